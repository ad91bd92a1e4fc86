#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// Estimated work of rasterising some triangles: the expected value over all positions on the pixel
/// grid.
struct FillCost {
    double triangles = 0.0; ///< triangles that meet the pixels at all
    double tilePairs = 0.0; ///< pairs of a triangle and a tile of 64 x 64 pixels
    double blocks = 0.0;    ///< blocks of 4 x 4 pixels, counted for each triangle
    double fragments = 0.0;

    FillCost& operator+=(const FillCost& other);
    /// The cost times `factor`.
    FillCost times(double factor) const;
};

/// Nanoseconds of rasterising, summed over all cores, measured with Mesa's llvmpipe.
struct FillWeights {
    double tilePair = 287.0;
    double block = 14.0;
    double of(const FillCost& cost) const {
        return tilePair * cost.tilePairs + block * cost.blocks;
    }
};

/// Estimates the fill of triangles in a picture's pixels.
class FillMeter {
  public:
    /// `clipFromObject`: for the triangles to measure; `open`: the pixels that may be drawn, in a
    /// picture of `width` by `height`.
    FillMeter(const glm::dmat4& clipFromObject, int width, int height, const PixelRectangle& open);

    /// The fill of a triangle with homogeneous corners. `nearCuts`: the near plane clips it.
    FillCost of(const std::array<glm::dvec4, 3>& corners, bool nearCuts = true) const;

  private:
    glm::dmat4 openFromObject_{1.0}; ///< x and y are -w and w at the borders of the open rectangle
    glm::dvec2 halfSize_;            ///< half the open rectangle's size, in pixels
};

} // namespace edgeshade
