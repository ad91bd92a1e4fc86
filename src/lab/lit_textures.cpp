#include "src/lab/lit_textures.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade::lab {
namespace {

gl::Texture uploaded(const std::vector<std::uint8_t>& pixels, int width, int height) {
    gl::Texture texture = gl::nearestTexture();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 pixels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

} // namespace

LitTextures::LitTextures(const std::vector<Answer>& answers, std::size_t lights, int width,
                         int height) {
    const auto columns = static_cast<std::size_t>(width);
    const glm::vec2 size(width, height);
    std::vector<std::uint8_t> pixels(4 * answers.size(), 0);
    glActiveTexture(GL_TEXTURE0);
    const gl::Name dark = textures_.emplace_back(uploaded(pixels, width, height)).name();
    for (std::size_t light = 0; light < lights; ++light) {
        const bool any = std::any_of(answers.begin(), answers.end(),
                                     [&](const Answer& answer) { return answer.lit.has(light); });
        if (!any) {
            lookups_.push_back({dark, size});
            continue;
        }
        for (std::size_t i = 0; i < answers.size(); ++i) { // GL's rows run upwards
            const std::size_t row = static_cast<std::size_t>(height) - 1 - i / columns;
            pixels[4 * (row * columns + i % columns)] = answers[i].lit.has(light) ? 255 : 0;
        }
        textures_.push_back(uploaded(pixels, width, height));
        lookups_.push_back({textures_.back().name(), size});
    }
    gl::requireNoError("uploading the oracle's answers");
}

} // namespace edgeshade::lab
