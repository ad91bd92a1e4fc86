#pragma once

#include "src/gl/color_target.hpp"
#include "src/render/drawing/whole_picture.hpp"
#include "src/render/shadow_map/shadow_map_target.hpp"

namespace edgeshade {

/// Filters maps of distances, in two passes over each face through another texture of the same
/// size.
class MapBlur {
  public:
    /// `settings`: isFiltered() must hold. Throws Error(unavailable) if the GL can't draw into such
    /// a texture.
    explicit MapBlur(const ShadowMapSettings& settings);

    /// Filters a face in place. Changes bindings; leaves the depth test and blending off.
    void filter(const ShadowMapTarget& map, std::size_t face) const;

    std::size_t bytes() const;

  private:
    int size_, halves_;
    gl::ColorTarget between_;
    WholePicture along_, across_; ///< filter rows of distances, then columns of the result
};

} // namespace edgeshade
