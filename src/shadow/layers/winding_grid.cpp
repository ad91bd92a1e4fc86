#include "src/shadow/layers/winding_grid.hpp"

namespace edgeshade {
namespace {

/// Cells: a segment that rises by less has no reliable slope.
constexpr double levelSegment = 1e-9;

/// Rounding of coordinates on a face, relative to the largest.
constexpr double faceRounding = 0x1p-46;

/// By how much the count grows from a corner to a place in its cell, at most, where a segment
/// touches the cell.
class Growth {
  public:
    Growth(const glm::dvec2& from, const glm::dvec2& to, int weight, double rounding, int side)
        : from_(from), along_(to - from), toRight_(std::max(weight, 0)),
          toLeft_(std::max(-weight, 0)) {
        const double length = std::abs(along_.x) + along_.y;
        near_ = (2.0 * rounding + 0x1p-44 * (length + side)) * length;
    }

    /// Above 0 to its left, and below 0 to its right, in multiples of its length.
    double sideOf(int row, int column) const {
        return along_.x * (row - from_.y) - along_.y * (column - from_.x);
    }
    /// The change of sideOf() to the next column.
    double step() const { return -along_.y; }
    bool isNear(double side) const { return std::abs(side) <= near_; }
    int from(double side) const {
        // Without branches, as nothing predicts them.
        const int left = side > near_, right = side < -near_;
        return left * toRight_ + right * toLeft_ + (1 - left - right) * 2 * (toRight_ + toLeft_);
    }

  private:
    glm::dvec2 from_, along_;
    int toRight_, toLeft_; ///< growth when it is crossed in that direction
    double near_;          ///< a corner with this side may be on either side
};

} // namespace

WindingGrid::WindingGrid(const Outline& part, int depth, double error)
    : side_(1 << depth), low_(part.u0, part.v0),
      perUnit_(side_ / (part.u1 - part.u0), side_ / (part.v1 - part.v0)),
      border_(static_cast<std::size_t>(side_), 0),
      cells_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {
    const double size = 1.0 + std::max({std::abs(part.u0), std::abs(part.u1), std::abs(part.v0),
                                        std::abs(part.v1)});
    rounding_ =
        2.0 * levelSegment + 2.0 * (error + faceRounding * size) * std::max(perUnit_.x, perUnit_.y);
}

double WindingGrid::Piece::slope() const {
    const double rise = to.y - from.y;
    return rise > levelSegment ? (to.x - from.x) / rise : 0.0;
}

int WindingGrid::add(const FaceSegment& segment) {
    const Piece piece = inCells(segment);
    if (misses(piece)) return -1;
    const double left = piece.left - rounding_, bottom = piece.from.y - rounding_;
    if (left > 0.0 && bottom > 0.0) {
        const int column = static_cast<int>(left), row = static_cast<int>(bottom);
        if (piece.right + rounding_ < column + 1 && piece.to.y + rounding_ < row + 1) {
            const Growth growth(piece.from, piece.to, piece.weight, rounding_, side_);
            cells_[at(row, column)].growth += growth.from(growth.sideOf(row, column));
            return static_cast<int>(at(row, column));
        }
    }
    const double slope = piece.slope();
    addCrossings(piece, slope);
    addGrowth(piece, slope);
    return -1;
}

/// Corners are at (column + 0, row + 0), and the border on the left at x = -0: what a piece crosses
/// is decided by the same numbers everywhere, so that the counts are exact for a chain that is bent
/// by no more than rounding.
void WindingGrid::addCrossings(const Piece& piece, double slope) {
    int row = static_cast<int>(std::ceil(std::max(piece.from.y, 0.0)));
    bool isLeft = piece.from.x < 0.0;
    const auto passBorder = [&](bool left) {
        if (left != isLeft && row > 0)
            border_[static_cast<std::size_t>(row)] += left ? piece.weight : -piece.weight;
        isLeft = left;
    };
    for (; row < side_ && row < piece.to.y; ++row) {
        const double x = piece.at(row, slope);
        passBorder(x < 0.0);
        if (isLeft || x > side_ - 1) continue;
        cells_[at(row, static_cast<int>(std::ceil(x)))].corner += piece.weight;
    }
    if (row < side_) passBorder(piece.to.x < 0.0);
}

void WindingGrid::addGrowth(const Piece& piece, double slope) {
    const Growth growth(piece.from, piece.to, piece.weight, rounding_, side_);
    forEachSpan(piece, slope, [&](int row, int left, int right) {
        double side = growth.sideOf(row, left);
        Cell* cell = &cells_[at(row, left)];
        for (int column = left; column <= right; ++column, side += growth.step())
            cell++->growth += growth.from(side);
    });
    // It may pass the first corner on another side than it did in the grid that `start` is from.
    if (growth.isNear(growth.sideOf(0, 0)) && piece.left < rounding_ && piece.right > -rounding_ &&
        piece.from.y < rounding_ && piece.to.y > -rounding_)
        atStart_ += std::abs(piece.weight);
}

void WindingGrid::sum(int start) {
    int atBorder = start + atStart_;
    for (int row = 0; row < side_; ++row) {
        atBorder += border_[static_cast<std::size_t>(row)];
        int count = atBorder;
        for (int column = 0; column < side_; ++column) {
            int& corner = cells_[at(row, column)].corner;
            count += corner;
            corner = count;
        }
    }
}

Outline WindingGrid::cell(int row, int column) const {
    const glm::dvec2 low = low_ + glm::dvec2(column, row) / perUnit_;
    const glm::dvec2 high = low_ + glm::dvec2(column + 1, row + 1) / perUnit_;
    return {low.x, high.x, low.y, high.y};
}

} // namespace edgeshade
