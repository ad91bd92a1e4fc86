#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/render/shadow_map/shadow_map.hpp"

#include <vector>

namespace edgeshade {

/// What a shadow map is drawn into: RGBA8 texels, a cube's six faces, several flat ones or one, and
/// a depth buffer that they share. Needs no extension; uses 24 bits of depth where it can. Some GLs
/// limit the size of a whole cube map (Mesa's software ones to 1 GiB): there its faces are textures
/// of their own.
class ShadowMapTarget {
  public:
    /// `form`: the one that is wanted; a cube comes apart where it must. `size`: texels along an
    /// edge. Textures are `texelWidth` times as wide; distances are drawn into their left part.
    /// Changes the framebuffer binding. Throws Error(unavailable) if the GL can't.
    ShadowMapTarget(const MapForm& form, int size, int texelWidth,
                    const gl::Capabilities& capabilities);

    /// Binds a face for drawing. The viewport is the caller's.
    void bindFace(std::size_t face) const;

    const MapForm& form() const { return form_; }
    /// Of a cube map one, else one for each face.
    std::array<gl::Name, 6> textures() const;
    /// How many are flat: of a cube map none.
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

/// Throws Error(unavailable) if such maps are more than the GL can hold.
void requireMapSize(int size, int texelWidth, const gl::Capabilities& capabilities);

} // namespace edgeshade
