#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/render/shadow_map/shadow_map.hpp"

#include <vector>

namespace edgeshade {

/// The target of a shadow map: RGBA8 texels in a cube's six faces, several flat ones or one, and a
/// depth buffer that they share. Needs no extension; uses 24 bits of depth if it can. Some GLs
/// limit the size of a whole cube map (Mesa's software renderers to 1 GiB); its faces are then
/// separate textures.
class ShadowMapTarget {
  public:
    /// `form`: the preferred one; a cube is split into flat faces if necessary. `size`: texels
    /// along an edge. Textures are `texelWidth` times as wide; distances are drawn into their left
    /// part. Changes the framebuffer binding. Throws Error(unavailable) if the GL can't.
    ShadowMapTarget(const MapForm& form, int size, int texelWidth,
                    const gl::Capabilities& capabilities);

    /// Binds a face for drawing. The caller sets the viewport.
    void bindFace(std::size_t face) const;

    const MapForm& form() const { return form_; }
    /// One texture for a cube map, otherwise one for each face.
    std::array<gl::Name, 6> textures() const;
    /// Number of flat textures: 0 for a cube map.
    int flatCount() const { return form_.cube ? 0 : static_cast<int>(textures_.size()); }
    int depthBits() const { return depthBits_; }
    std::size_t bytes() const;

  private:
    MapForm form_;
    int size_, width_;
    int depthBits_ = 0;
    std::vector<gl::Texture> textures_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
};

/// Throws Error(unavailable) if the GL can't hold such maps.
void requireMapSize(int size, int texelWidth, const gl::Capabilities& capabilities);

} // namespace edgeshade
