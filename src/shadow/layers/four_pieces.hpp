#pragma once

#include "src/shadow/layers/face_chain.hpp"
#include "src/shadow/silhouette/lanes.hpp"

#include <array>

/// Four segments of a WindingGrid at once.
namespace edgeshade::fours {

using namespace silhouette;

/// Rounding of a corner's side of a segment, as a share of the terms.
inline constexpr float sideRounding = 0x1p-20f;

/// Four segments in cells, upwards.
struct Pieces {
    Floats fromX, fromY, toX, toY;
    Ints weight;

    Pieces(const std::array<const FaceSegment*, lanes>& segments, const glm::vec2& low,
           const glm::vec2& perUnit) {
        for (std::size_t i = 0; i < lanes; ++i) {
            fromX[i] = segments[i]->from.x;
            fromY[i] = segments[i]->from.y;
            toX[i] = segments[i]->to.x;
            toY[i] = segments[i]->to.y;
            weight[i] = segments[i]->weight;
        }
        fromX = (fromX - low.x) * perUnit.x;
        fromY = (fromY - low.y) * perUnit.y;
        toX = (toX - low.x) * perUnit.x;
        toY = (toY - low.y) * perUnit.y;
    }
};

/// Columns or rows of cells, from 0 to `last`.
inline Ints placed(Floats cells, Floats last) {
    return __builtin_convertvector(lesser(greater(cells, all(0.0f)), last), Ints);
}

/// By how much counts grow from corners to places in their cells, at most, where segments touch the
/// cells (docs/method.md, C48).
class Growths {
  public:
    Growths(const Pieces& pieces, Floats rounding, int side)
        : pieces_(pieces), alongX_(pieces.toX - pieces.fromX), alongY_(pieces.toY - pieces.fromY),
          toRight_(pieces.weight & (pieces.weight > 0)),
          toLeft_(-pieces.weight & (pieces.weight < 0)) {
        const Floats length = magnitude(alongX_) + alongY_;
        near_ = (2.0f * rounding + sideRounding * (length + static_cast<float>(side))) * length;
    }

    /// Growth from the corners (x, y).
    Ints from(Floats x, Floats y) const {
        const Floats side = alongX_ * (y - pieces_.fromY) - alongY_ * (x - pieces_.fromX);
        const Ints left = side > near_, right = side < -near_;
        return (left & toRight_) + (right & toLeft_) +
               (~(left | right) & (2 * (toRight_ + toLeft_)));
    }

  private:
    const Pieces& pieces_;
    Floats alongX_, alongY_, near_;
    Ints toRight_, toLeft_;
};

} // namespace edgeshade::fours
