#include "src/rivals/maps/warp_table.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

WarpTable::WarpTable() : texture_(gl::nearestTexture()) {
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
