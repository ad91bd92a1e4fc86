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
    Ints weight, starts, level; ///< `level`: all bits, or none

    Pieces(const std::array<const FaceSegment*, lanes>& segments, const glm::vec2& low,
           const glm::vec2& perUnit) {
        for (std::size_t i = 0; i < lanes; ++i) {
            fromX[i] = segments[i]->from.x;
            fromY[i] = segments[i]->from.y;
            toX[i] = segments[i]->to.x;
            toY[i] = segments[i]->to.y;
            weight[i] = segments[i]->weight;
            starts[i] = segments[i]->starts;
            level[i] = -static_cast<int>(segments[i]->level);
        }
        fromX = (fromX - low.x) * perUnit.x;
        fromY = (fromY - low.y) * perUnit.y;
        toX = (toX - low.x) * perUnit.x;
        toY = (toY - low.y) * perUnit.y;
    }

    Ints weightMagnitude() const { return weight > 0 ? weight : -weight; }
    /// The magnitudes of level segments' weights.
    Ints ifLevel() const { return level & weightMagnitude(); }
};

/// Columns or rows of cells, from 0 to `last`.
inline Ints placed(Floats cells, Floats last) {
    return __builtin_convertvector(lesser(greater(cells, all(0.0f)), last), Ints);
}

/// By how much counts grow within the cells that segments touch, at most (docs/method.md, C48).
class Growths {
  public:
    Growths(const Pieces& pieces, Floats rounding, int side)
        : pieces_(pieces), alongX_(pieces.toX - pieces.fromX), alongY_(pieces.toY - pieces.fromY),
          paths_(pieces.weight & (pieces.weight > 0)), weight_(pieces.weightMagnitude()),
          level_(pieces.ifLevel()) {
        const Floats length = magnitude(alongX_) + alongY_;
        near_ = (2.0f * rounding + sideRounding * (length + static_cast<float>(side))) * length;
        border_ = level_ | (~pieces.level & (alongX_ >= -rounding) & (weight_ - paths_));
    }

    /// Above 0 to their left, and below 0 to their right, in multiples of their lengths.
    Floats sideOf(Floats x, Floats y) const {
        return alongX_ * (y - pieces_.fromY) - alongY_ * (x - pieces_.fromX);
    }
    /// Whether their lines pass between two points with these sides, the lower one first.
    Ints between(Floats low, Floats high) const { return (low < -near_) & (high > near_); }

    /// Within a cell. `startsHere`: their lower ends are in it. `passLeft`: they come across its
    /// left border.
    Ints within(Ints startsHere, Ints passLeft) const {
        return level_ + ((startsHere & pieces_.starts) | (~(startsHere | passLeft) & paths_));
    }
    /// Along a cell's left border, upwards from a corner that is away from them.
    Ints acrossLeft() const { return border_; }
    /// The same from a corner with this side that is as high as some of each.
    Ints acrossLeft(Floats side) const { return border_ + ((magnitude(side) <= near_) & weight_); }

  private:
    const Pieces& pieces_;
    Floats alongX_, alongY_, near_;
    Ints paths_, weight_, level_, border_;
};

} // namespace edgeshade::fours
