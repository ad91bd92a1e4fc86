#include "src/gl/float_table.hpp"

#include "preprocess/base/error.hpp"

#include <algorithm>
#include <bit>
#include <GLES2/gl2.h>

namespace edgeshade::gl {
namespace {

constexpr std::size_t mostColumns = 2048;
constexpr int floatBits = 23;

} // namespace

FloatTable::FloatTable(std::span<const glm::vec2> texels, const Capabilities& capabilities) {
    upload(texels.data(), texels.size(), 2, capabilities);
}

FloatTable::FloatTable(std::span<const glm::vec4> texels, const Capabilities& capabilities) {
    upload(texels.data(), texels.size(), 4, capabilities);
}

void FloatTable::upload(const void* texels, std::size_t count, std::size_t channels,
                        const Capabilities& capabilities) {
    const auto largest = static_cast<std::size_t>(capabilities.largestTexture);
    const std::size_t columns = std::min(
        {std::bit_ceil(std::max<std::size_t>(1, count)), mostColumns, std::bit_floor(largest)});
    const std::size_t rows = std::max<std::size_t>(1, (count + columns - 1) / columns);
    if (rows > largest)
        throw Error(ExitStatus::unavailable, "A table of " + std::to_string(count) +
                                                 " texels is larger than this GL's largest "
                                                 "texture.");
    Name name = 0;
    glGenTextures(1, &name);
    texture_ = Texture(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const GLenum format = channels == 2 ? GL_LUMINANCE_ALPHA : GL_RGBA;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), static_cast<GLsizei>(columns),
                 static_cast<GLsizei>(rows), 0, format, GL_FLOAT, nullptr);
    // Whole rows, then what the last one has: nothing is copied for their sake.
    const std::size_t whole = count / columns, rest = count % columns;
    const auto fill = [&](std::size_t row, std::size_t width, std::size_t height) {
        if (width == 0 || height == 0) return;
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), static_cast<GLsizei>(width),
                        static_cast<GLsizei>(height), format, GL_FLOAT,
                        static_cast<const float*>(texels) + row * columns * channels);
    };
    fill(0, columns, whole);
    fill(whole, rest, 1);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    requireNoError("uploading a table of floats");
    size_ = {static_cast<float>(columns), 1.0f / static_cast<float>(columns),
             1.0f / static_cast<float>(rows)};
    bytes_ = columns * rows * channels * sizeof(float);
}

bool hasFloatTables(const Capabilities& capabilities) {
    return capabilities.has("GL_OES_texture_float") &&
           capabilities.fragmentHighpMantissaBits >= floatBits && capabilities.textureUnits >= 4;
}

} // namespace edgeshade::gl
