#pragma once

#include "src/gl/color_target.hpp"
#include "src/render/drawing/whole_picture.hpp"
#include "src/render/shadow_map/shadow_map_target.hpp"

namespace edgeshade {

/// Makes filtered maps of distances: two passes over each face, by way of one more texture as
/// large.
class MapBlur {
  public:
    /// `settings`: isFiltered(). Throws Error(unavailable) if the GL can't draw into such a
    /// texture.
    explicit MapBlur(const ShadowMapSettings& settings);

    /// In place. Changes what is bound; leaves depth test and blending off.
    void filter(const ShadowMapTarget& map, std::size_t face) const;

    std::size_t bytes() const;

  private:
    int size_, halves_;
    gl::ColorTarget between_;
    WholePicture along_, across_; ///< rows of distances, then columns of what became of them
};

} // namespace edgeshade
