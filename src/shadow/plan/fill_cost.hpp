#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// What rasterising some triangles takes, by estimate: what is expected where nothing is known of
/// how they lie on the grid of pixels.
struct FillCost {
    double triangles = 0.0; ///< that meet the pixels at all
    double tilePairs = 0.0; ///< of a triangle and a tile of 64 x 64 pixels
    double blocks = 0.0;    ///< of 4 x 4 pixels, triangle by triangle
    double fragments = 0.0;

    FillCost& operator+=(const FillCost& other);
    /// Of so many times as much.
    FillCost times(double factor) const;
};

/// Nanoseconds that a rasteriser takes: as measured with Mesa's llvmpipe, all cores' together.
struct FillWeights {
    double tilePair = 287.0;
    double block = 14.0;
    double of(const FillCost& cost) const {
        return tilePair * cost.tilePairs + block * cost.blocks;
    }
};

/// Measures triangles in a picture's pixels.
class FillMeter {
  public:
    /// `clipFromObject`: of what is measured; `open`: the pixels of a picture of this size that
    /// may be drawn.
    FillMeter(const glm::dmat4& clipFromObject, int width, int height, const PixelRectangle& open);

    /// Of a triangle, homogeneous. `nearCuts`: what is before the near plane is cut off.
    FillCost of(const std::array<glm::dvec4, 3>& corners, bool nearCuts = true) const;

  private:
    glm::dmat4 openFromObject_{1.0}; ///< x and y are -w and w at the open rectangle's borders
    glm::dvec2 halfSize_;            ///< of that rectangle, in pixels
};

} // namespace edgeshade
