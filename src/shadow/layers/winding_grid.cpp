#include "src/shadow/layers/winding_grid.hpp"

#include "src/shadow/layers/four_pieces.hpp"

#include <cstring>

namespace edgeshade {
namespace {

using namespace fours;

/// Rounding of coordinates on a face, relative to the largest.
constexpr double faceRounding = 0x1p-19;

/// The least whole number that isn't below `cells`, which isn't below 0.
int ceiling(float cells) {
    const int below = static_cast<int>(cells);
    return below + (static_cast<float>(below) < cells ? 1 : 0);
}

/// The same as Growths, of one segment.
class Growth {
  public:
    Growth(const glm::vec2& from, const glm::vec2& to, int weight, int starts, bool level,
           float rounding, int side)
        : from_(from), to_(to), along_(to - from), rounding_(rounding), starts_(starts),
          paths_(std::max(weight, 0)), weight_(std::abs(weight)) {
        const float length = std::abs(along_.x) + along_.y;
        near_ = (2.0f * rounding + sideRounding * (length + static_cast<float>(side))) * length;
        if (level)
            level_ = border_ = weight_;
        else if (along_.x >= -rounding)
            border_ = weight_ - paths_;
    }

    int within(int row, int column) const {
        const float x = static_cast<float>(column), y = static_cast<float>(row);
        const bool startsHere = from_.x + rounding_ >= x && from_.x - rounding_ < x + 1.0f &&
                                from_.y + rounding_ >= y && from_.y - rounding_ < y + 1.0f;
        if (startsHere) return level_ + starts_;
        const bool passesLeft = from_.x + rounding_ < x && to_.x - rounding_ > x &&
                                sideOf(x, y) < -near_ && sideOf(x, y + 1.0f) > near_;
        return level_ + (passesLeft ? 0 : paths_);
    }
    int acrossLeft(int row, int column) const {
        return border_ + (isNear(row, column) ? weight_ : 0);
    }
    bool isNear(int row, int column) const {
        const float x = static_cast<float>(column), y = static_cast<float>(row);
        return std::abs(sideOf(x, y)) <= near_ && y >= from_.y - rounding_ &&
               y <= to_.y + rounding_;
    }

  private:
    /// Above 0 to its left, and below 0 to its right, in multiples of its length.
    float sideOf(float x, float y) const {
        return along_.x * (y - from_.y) - along_.y * (x - from_.x);
    }

    glm::vec2 from_, to_, along_;
    float rounding_;
    float near_ = 0.0f; ///< corners with this side of the segment may be on either side of it
    int starts_, paths_, weight_;
    int level_ = 0, border_ = 0;
};

} // namespace

void WindingGrid::begin(const Outline& part, int depth, double error) {
    depth_ = depth;
    side_ = 1 << depth;
    low_ = {part.u0, part.v0};
    perUnit_ = {side_ / (part.u1 - part.u0), side_ / (part.v1 - part.v0)};
    atStart_ = 0;
    const auto side = static_cast<std::size_t>(side_);
    border_.assign(side, 0);
    cells_.assign(side * side + 2 * side + 2, {});
    const double size = 1.0 + std::max({std::abs(part.u0), std::abs(part.u1), std::abs(part.v0),
                                        std::abs(part.v1)});
    const double perUnit = std::max(side_ / (part.u1 - part.u0), side_ / (part.v1 - part.v0));
    rounding_ =
        static_cast<float>(2.0 * levelSegment + 2.0 * (error + faceRounding * size) * perUnit);
}

void WindingGrid::add(std::span<const FaceSegment> segments, std::vector<int>& places) {
    places.resize(segments.size());
    across_.resize(segments.size());
    std::size_t across = 0, i = 0;
    const Floats rounding = all(rounding_), last = all(static_cast<float>(side_ - 1));
    // Without branches, as nothing predicts them.
    for (; i + lanes <= segments.size(); i += lanes) {
        const fours::Pieces pieces(
            {&segments[i], &segments[i + 1], &segments[i + 2], &segments[i + 3]}, low_, perUnit_);
        const Floats left = lesser(pieces.fromX, pieces.toX) - rounding;
        const Floats right = greater(pieces.fromX, pieces.toX) + rounding;
        const Floats bottom = pieces.fromY - rounding, top = pieces.toY + rounding;
        const Ints column = placed(left, last), row = placed(bottom, last);
        const Floats x = __builtin_convertvector(column, Floats);
        const Floats y = __builtin_convertvector(row, Floats);
        const Ints within = (left > x) & (bottom > y) & (right < x + 1.0f) & (top < y + 1.0f);
        const Ints growth = within & (pieces.starts + pieces.ifLevel());
        const Ints cell = (row << depth_) + column;
        const Ints only = (cell & within) | (all(elsewhere()) & ~within);
        std::memcpy(&places[i], &only, sizeof(only));
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            cells_[static_cast<std::size_t>(cell[lane])].growth += growth[lane];
            across_[across] = static_cast<std::uint32_t>(i + lane);
            across += static_cast<std::size_t>(within[lane] + 1);
        }
    }
    for (; i < segments.size(); ++i) {
        places[i] = elsewhere();
        across_[across++] = static_cast<std::uint32_t>(i);
    }
    std::size_t k = 0;
    for (; k + lanes <= across; k += lanes)
        addAcross(segments, &across_[k], places);
    for (; k < across; ++k)
        addAcross(inCells(segments[across_[k]]));
}

void WindingGrid::addAcross(std::span<const FaceSegment> segments, const std::uint32_t* four,
                            std::vector<int>& places) {
    const Floats rounding = all(rounding_), end = all(static_cast<float>(side_));
    const Floats last = end - 1.0f;
    const fours::Pieces pieces(
        {&segments[four[0]], &segments[four[1]], &segments[four[2]], &segments[four[3]]}, low_,
        perUnit_);
    const Floats least = lesser(pieces.fromX, pieces.toX), most = greater(pieces.fromX, pieces.toX);
    const Floats left = least - rounding, right = most + rounding;
    const Floats bottom = pieces.fromY - rounding, top = pieces.toY + rounding;
    const Ints column = placed(left, last), row = placed(bottom, last);
    const Floats x = __builtin_convertvector(column, Floats);
    const Floats y = __builtin_convertvector(row, Floats);
    // In two rows and columns of cells, away from the rectangle's border.
    const Ints small = (left > x) & (bottom > y) & (right < x + 2.0f) & (top < y + 2.0f) &
                       (right < end) & (top < end);
    const Floats nextX = x + 1.0f, nextY = y + 1.0f;
    // As Piece::slope(), Piece::at(), addCrossings() and forEachSpan() do.
    const Floats rise = pieces.toY - pieces.fromY;
    const Ints steep = rise > levelSegment;
    const Floats slope = steep ? (pieces.toX - pieces.fromX) / rise : all(0.0f);
    const Floats height = lesser(greater(nextY, pieces.fromY), pieces.toY);
    const Floats at = lesser(greater(pieces.fromX + (height - pieces.fromY) * slope, least), most);
    const Floats atLine =
        lesser(greater(pieces.fromX + (nextY - pieces.fromY) * slope, least), most);
    const Ints crosses = small & (pieces.fromY <= nextY) & (nextY < pieces.toY) &
                         (atLine <= static_cast<float>(side_ - 1));
    const Ints crossed = ((row + 1) << depth_) + column + 1 - (atLine > nextX);
    const Floats slack = steep ? rounding * (1.0f + magnitude(slope)) : all(2.0f);
    const auto reachesLeft = [&](Floats other) {
        return greater(lesser(at, other) - slack, least) - rounding < nextX;
    };
    const auto reachesRight = [&](Floats other) {
        return lesser(greater(at, other) + slack, most) + rounding >= nextX;
    };
    const Ints two = small & (top >= nextY), one = ~two;
    const Ints lowLeft = small & (one | reachesLeft(pieces.fromX));
    const Ints lowRight = small & ((one & (right >= nextX)) | (two & reachesRight(pieces.fromX)));
    const Ints highLeft = two & reachesLeft(pieces.toX);
    const Ints highRight = two & reachesRight(pieces.toX);
    const Growths growths(pieces, rounding, side_);
    const Ints fromLeft = pieces.fromX - rounding < nextX,
               fromLow = pieces.fromY - rounding < nextY;
    const Ints fromRight = pieces.fromX + rounding >= nextX;
    const Ints fromHigh = pieces.fromY + rounding >= nextY;
    const Floats low = growths.sideOf(nextX, y), middle = growths.sideOf(nextX, nextY);
    const Floats high = growths.sideOf(nextX, nextY + 1.0f);
    const Ints passes = ~fromRight & (pieces.toX - rounding > nextX);
    const Ints none = all(0);
    const Ints grow[4] = {
        lowLeft & growths.within(fromLow & fromLeft, none),
        lowRight & (growths.within(fromLow & fromRight, passes & growths.between(low, middle)) +
                    (lowLeft & growths.acrossLeft())),
        highLeft & growths.within(fromHigh & fromLeft, none),
        highRight & (growths.within(fromHigh & fromRight, passes & growths.between(middle, high)) +
                     (highLeft & growths.acrossLeft(middle)))};
    const Ints weight = crosses & pieces.weight;
    const Ints cell = (row << depth_) + column;
    const auto side = static_cast<std::size_t>(side_);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (small[lane] == 0) {
            addAcross(inCells(segments[four[lane]]));
            continue;
        }
        places[four[lane]] = inSquare(cell[lane]);
        Cell* const here = &cells_[static_cast<std::size_t>(cell[lane])];
        here[0].growth += grow[0][lane];
        here[1].growth += grow[1][lane];
        here[side].growth += grow[2][lane];
        here[side + 1].growth += grow[3][lane];
        cells_[static_cast<std::size_t>(crossed[lane])].corner += weight[lane];
    }
}

void WindingGrid::addAcross(const Piece& piece) {
    if (misses(piece)) return;
    const float slope = piece.slope();
    addCrossings(piece, slope);
    addGrowth(piece, slope);
}

/// Corners are at (column + 0, row + 0), and the border on the left at x = -0: what a piece crosses
/// is decided by the same numbers everywhere, so that the counts are exact for a chain that is bent
/// by no more than rounding.
void WindingGrid::addCrossings(const Piece& piece, float slope) {
    const float side = static_cast<float>(side_);
    int row = ceiling(std::clamp(piece.from.y, 0.0f, side));
    bool isLeft = piece.from.x < 0.0f;
    const auto passBorder = [&](bool left) {
        if (left != isLeft && row > 0)
            border_[static_cast<std::size_t>(row)] += left ? piece.weight : -piece.weight;
        isLeft = left;
    };
    for (; row < side_ && static_cast<float>(row) < piece.to.y; ++row) {
        const float x = piece.at(static_cast<float>(row), slope);
        passBorder(x < 0.0f);
        if (isLeft || x > side - 1.0f) continue;
        cells_[at(row, ceiling(x))].corner += piece.weight;
    }
    if (row < side_) passBorder(piece.to.x < 0.0f);
}

void WindingGrid::addGrowth(const Piece& piece, float slope) {
    const Growth growth(piece.from, piece.to, piece.weight, piece.starts, piece.level, rounding_,
                        side_);
    const bool fromOutside = piece.left < rounding_;
    forEachSpan(piece, slope, [&](int row, int left, int right) {
        const int firstBorder = left == 0 && fromOutside ? 0 : left + 1;
        for (int column = left; column <= right; ++column)
            cells_[at(row, column)].growth +=
                growth.within(row, column) +
                (column >= firstBorder ? growth.acrossLeft(row, column) : 0);
    });
    // It may pass the first corner on another side than it did in the grid that `start` is from.
    if (piece.left < rounding_ && piece.right > -rounding_ && growth.isNear(0, 0))
        atStart_ += std::abs(piece.weight);
}

void WindingGrid::sum(int start, bool isRaised) {
    int atBorder = start + (isRaised ? 0 : atStart_);
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
    const glm::dvec2 start(low_), size = 1.0 / glm::dvec2(perUnit_);
    const glm::dvec2 low = start + glm::dvec2(column, row) * size;
    const glm::dvec2 high = start + glm::dvec2(column + 1, row + 1) * size;
    return {low.x, high.x, low.y, high.y};
}

} // namespace edgeshade
