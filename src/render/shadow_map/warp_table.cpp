#include "src/render/shadow_map/warp_table.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

WarpTable::WarpTable() {
    gl::Name name = 0;
    glGenTextures(1, &name);
    texture_ = gl::Texture(name);
    glBindTexture(GL_TEXTURE_2D, name);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void WarpTable::fill(const MapWarp& warp) const {
    std::vector<std::uint8_t> texels;
    texels.reserve(bytes());
    for (const glm::u16vec2& node : warp.nodes)
        for (glm::length_t axis = 0; axis < 2; ++axis) {
            texels.push_back(static_cast<std::uint8_t>(node[axis] >> 8));
            texels.push_back(static_cast<std::uint8_t>(node[axis] & 0xFF));
        }
    constexpr GLsizei size = MapWarp::cells + 1;
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    gl::requireNoError("uploading a shadow map's warp");
}

} // namespace edgeshade
