#include "src/rivals/maps/map_blur.hpp"

#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"
#include "src/rivals/maps/map_filters.hpp"

#include <GLES2/gl2.h>
#include <string>
#include <vector>

namespace edgeshade {
namespace {

std::vector<std::string> definesOf(const ShadowMapSettings& settings, bool distances) {
    std::vector<std::string> defines = filterDefines(settings.filter);
    defines.push_back("PCF " + std::to_string(settings.pcf));
    if (distances) defines.emplace_back("DISTANCES");
    return defines;
}

} // namespace

MapBlur::MapBlur(const ShadowMapSettings& settings)
    : size_(settings.size), halves_(texelWidthOf(settings)), between_(halves_ * size_, size_),
      along_(shaders::shadow_map_blur_frag, definesOf(settings, true)),
      across_(shaders::shadow_map_blur_frag, definesOf(settings, false)) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(ExitStatus::unavailable, "This GL can't filter a shadow map of " +
                                                 std::to_string(settings.size) + " texels.");
}

void MapBlur::filter(const ShadowMapTarget& map, std::size_t face) const {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    const float texel = 1.0f / static_cast<float>(size_);
    const auto draw = [&](const WholePicture& by, gl::Name from, const glm::vec2& step) {
        const gl::Program& program = by.use();
        program.setTexture("u_from", 0, from);
        program.set("u_texel", glm::vec2(texel));
        program.set("u_along", texel * step);
        for (int half = 0; half < halves_; ++half) {
            glViewport(half * size_, 0, size_, size_);
            program.set("u_half", static_cast<float>(half));
            by.draw();
        }
    };
    glBindFramebuffer(GL_FRAMEBUFFER, between_.framebuffer.name());
    draw(along_, map.textures()[face], {1.0f, 0.0f});
    map.bindFace(face);
    draw(across_, between_.texture.name(), {0.0f, 1.0f});
    glBindTexture(GL_TEXTURE_2D, 0);
}

std::size_t MapBlur::bytes() const {
    return 4 * static_cast<std::size_t>(halves_ * size_) * static_cast<std::size_t>(size_);
}

} // namespace edgeshade
