#include "src/gl/float_table.hpp"

#include "preprocess/base/error.hpp"

#include <algorithm>
#include <bit>
#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

constexpr std::size_t mostColumns = 2048;
constexpr int floatBits = 23;
constexpr GLint sizedFormat = 0x8814; // GL_RGBA32F
constexpr char uploading[] = "uploading a table of floats";

GLenum formatOf(std::size_t channels) {
    return channels == 2 ? GL_LUMINANCE_ALPHA : GL_RGBA;
}

/// ES 3 has sized float formats, and needs no extension for them.
bool isEs3(const Capabilities& capabilities) {
    return capabilities.version.starts_with("OpenGL ES 3");
}

} // namespace

FloatTable::FloatTable(std::span<const glm::vec4> pairs, std::size_t count,
                       const Capabilities& capabilities) {
    allocate(count, 2, capabilities);
    fillRows(0, pairs.data(), count);
    requireNoError(uploading);
}

FloatTable::FloatTable(std::span<const glm::vec4> texels, const Capabilities& capabilities) {
    allocate(texels.size(), 4, capabilities);
    fillRows(0, texels.data(), texels.size());
    requireNoError(uploading);
}

FloatTable::FloatTable(std::size_t texels, const Capabilities& capabilities) {
    allocate(texels, 4, capabilities);
}

void FloatTable::fill(std::size_t first, std::span<const glm::vec4> texels) const {
    fillRows(first, texels.data(), texels.size());
}

void FloatTable::allocate(std::size_t count, std::size_t channels,
                          const Capabilities& capabilities) {
    const auto largest = static_cast<std::size_t>(capabilities.largestTexture);
    const std::size_t columns = std::min(
        {std::bit_ceil(std::max<std::size_t>(1, count)), mostColumns, std::bit_floor(largest)});
    const std::size_t rows = std::max<std::size_t>(1, (count + columns - 1) / columns);
    if (rows > largest)
        throw Error(ExitStatus::unavailable, "A table of " + std::to_string(count) +
                                                 " texels is larger than this GL's largest "
                                                 "texture.");
    texture_ = nearestTexture();
    const GLenum format = formatOf(channels);
    const bool sized = channels == 4 && isEs3(capabilities);
    glTexImage2D(GL_TEXTURE_2D, 0, sized ? sizedFormat : static_cast<GLint>(format),
                 static_cast<GLsizei>(columns), static_cast<GLsizei>(rows), 0, format, GL_FLOAT,
                 nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    channels_ = channels;
    columns_ = columns;
    size_ = {static_cast<float>(columns), 1.0f / static_cast<float>(columns),
             1.0f / static_cast<float>(rows)};
    bytes_ = columns * rows * channels * sizeof(float);
}

void FloatTable::fillRows(std::size_t first, const void* texels, std::size_t count) const {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    // Uploads whole rows, then the rest of the last one, so that nothing has to be copied.
    const std::size_t whole = count / columns_, rest = count % columns_;
    const auto rows = [&](std::size_t row, std::size_t width, std::size_t height) {
        if (width == 0 || height == 0) return;
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(first / columns_ + row),
                        static_cast<GLsizei>(width), static_cast<GLsizei>(height),
                        formatOf(channels_), GL_FLOAT,
                        static_cast<const float*>(texels) + row * columns_ * channels_);
    };
    rows(0, columns_, whole);
    rows(whole, rest, 1);
    glBindTexture(GL_TEXTURE_2D, 0);
}

bool hasWideTables(const Capabilities& capabilities) {
    return (isEs3(capabilities) || capabilities.has("GL_OES_texture_float")) &&
           capabilities.fragmentHighpMantissaBits >= floatBits;
}

bool hasFloatTables(const Capabilities& capabilities) {
    return capabilities.has("GL_OES_texture_float") &&
           capabilities.fragmentHighpMantissaBits >= floatBits && capabilities.textureUnits >= 4;
}

} // namespace edgeshade::gl
