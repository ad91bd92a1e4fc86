#include "src/shadow/layers/face_bound.hpp"

#include "src/shadow/layers/touch_grid.hpp"
#include "src/shadow/layers/winding_grid.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgeshade {
namespace {

// Depths of grids: a face's first one, and those of crowded cells.
constexpr int coarsest = 4, finest = 6, leastFiner = 1, mostFiner = 3;
constexpr std::size_t segmentsPerCell = 16; ///< in a grid with the right depth
constexpr int mostHalvings = 14;            ///< most halvings of a face's filled part

// Segments and polygons in crowded cells, from which on dividing costs more than bounding by
// triangles does.
constexpr std::size_t leastWork = 20'000, workPerSegment = 4;

/// Room around a face's contents, as shares of their extent. No binary fractions, so that corners
/// of cells are not in line with regular models.
constexpr double roomBelow = 0.00317, roomAbove = 0.00283;

/// The same as a share of the coordinates: the rectangle has an area.
constexpr double leastRoom = 1e-10;

/// How far the rectangle may extend beyond a face of a cube.
constexpr double beyondFace = 1.0007;

int depthFor(std::size_t segments, int least, int most) {
    int depth = least;
    while (depth < most && (segmentsPerCell << (2 * depth)) < segments)
        ++depth;
    return depth;
}

/// A cell that may count more than the limit, and all that may touch it.
struct Crowded {
    int row, column;
    std::vector<FaceSegment> segments{};
    std::vector<FacePolygon> uncertain{};
};

/// Finds the crowded cells of a grid by their places.
class CrowdedPlaces {
  public:
    CrowdedPlaces(std::vector<Crowded>& cells, int side)
        : cells_(cells), side_(side), at_(static_cast<std::size_t>(side * side), -1),
          before_(static_cast<std::size_t>((side + 1) * (side + 1)), 0),
          inSquare_(static_cast<std::size_t>(side * side + 1), 0) {
        inSquare_.back() = 1;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto [row, column] = std::pair(cells[i].row, cells[i].column);
            at_[static_cast<std::size_t>(row * side + column)] = static_cast<int>(i);
            for (int r = std::max(row - 1, 0); r <= row; ++r)
                for (int c = std::max(column - 1, 0); c <= column; ++c)
                    inSquare_[static_cast<std::size_t>(r * side + c)] = 1;
        }
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                before_[corner(row + 1, column + 1)] =
                    before_[corner(row, column + 1)] + before_[corner(row + 1, column)] -
                    before_[corner(row, column)] +
                    (at_[static_cast<std::size_t>(row * side + column)] >= 0 ? 1 : 0);
    }

    bool anyAmong(const WindingGrid::Cells& cells) const {
        return before_[corner(cells.top + 1, cells.right + 1)] -
                   before_[corner(cells.bottom, cells.right + 1)] -
                   before_[corner(cells.top + 1, cells.left)] +
                   before_[corner(cells.bottom, cells.left)] >
               0;
    }

    /// Whether any are in a square as of WindingGrid::add(). Elsewhere some may be.
    bool anyInSquare(int cell) const { return inSquare_[static_cast<std::size_t>(cell)] != 0; }

    /// The crowded cell with an index, row * side + column; null if that cell isn't crowded.
    Crowded* at(int index) const {
        const int crowded = at_[static_cast<std::size_t>(index)];
        return crowded < 0 ? nullptr : &cells_[static_cast<std::size_t>(crowded)];
    }

    /// Calls use(cell) with the crowded cells among [left, right] of a row.
    template <class Use>
    void forEach(int row, int left, int right, Use use) const {
        for (int column = left; column <= right; ++column)
            if (Crowded* const cell = at(row * side_ + column)) use(*cell);
    }

  private:
    std::size_t corner(int row, int column) const {
        return static_cast<std::size_t>(row * (side_ + 1) + column);
    }

    std::vector<Crowded>& cells_;
    int side_;
    std::vector<int> at_;     ///< index in cells_; -1: not crowded
    std::vector<int> before_; ///< by corner: number of crowded cells below and to the left of it
    std::vector<std::uint8_t> inSquare_; ///< by cell: whether the square from it has crowded cells
};

} // namespace

Outline filledPart(const FaceChain& face, const LightView& view) {
    if (face.segments.empty() && face.uncertain.empty()) return {};
    const double end = view.directional ? INFINITY : beyondFace;
    const glm::dvec2 least = face.frame.to(glm::dvec2(-end)), most = face.frame.to(glm::dvec2(end));
    Outline part = face.reached;
    const auto widen = [&](double& low, double& high, double first, double last) {
        const double extent = high - low;
        const double room =
            leastRoom * std::max(std::abs(low), std::abs(high)) + 4.0 * face.error + 1e-200;
        low = std::max(low - roomBelow * extent - room, first);
        high = std::min(high + roomAbove * extent + room, last);
    };
    widen(part.u0, part.u1, least.x, most.x);
    widen(part.v0, part.v1, least.y, most.y);
    return part;
}

bool FaceBound::holds(const FaceChain& face, const Outline& part, int start) {
    start += face.everywhere;
    if (start > limit_ || !std::isfinite(face.error)) return false;
    most_ = std::max(most_, start);
    if (part.empty()) return true;
    error_ = face.error;
    workLeft_ = leastWork + workPerSegment * face.segments.size();
    return holds({part, 0, face.segments, face.uncertain, start},
                 depthFor(face.segments.size(), coarsest, finest));
}

bool FaceBound::holds(const Part& part, int depth) {
    WindingGrid grid(part.outline, depth, error_);
    std::vector<int> placeOf; // by segment
    grid.add(part.segments, placeOf);
    grid.sum(part.start);
    std::optional<TouchGrid> touched;
    if (!part.uncertain.empty()) {
        touched.emplace(part.outline, depth);
        for (const FacePolygon& polygon : part.uncertain)
            touched->add(polygon.all());
        touched->sum();
    }

    const int side = grid.side();
    std::vector<Crowded> crowded;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const int bound = grid.bound(row, column) +
                              (touched ? static_cast<int>(touched->count(row, column)) : 0);
            if (bound <= limit_)
                most_ = std::max(most_, bound);
            else if (grid.corner(row, column) > limit_)
                return false; // finer grids would have the same corner
            else
                crowded.push_back({row, column});
        }
    if (crowded.empty()) return true;
    if (part.halvings + depth >= mostHalvings) return false;

    const CrowdedPlaces places(crowded, side);
    for (std::size_t i = 0; i < part.segments.size(); ++i) {
        const auto put = [&](int row, int left, int right) {
            places.forEach(row, left, right,
                           [&](Crowded& cell) { cell.segments.push_back(part.segments[i]); });
        };
        // One test that is nearly always false, whatever the place.
        const int place = placeOf[i];
        if (!places.anyInSquare(place >= 0 ? place : WindingGrid::inSquare(place))) continue;
        if (place >= 0) {
            if (Crowded* const cell = places.at(place)) cell->segments.push_back(part.segments[i]);
            continue;
        }
        if (place == grid.elsewhere()) {
            const auto around = grid.cellsAround(part.segments[i]);
            if (!around || !places.anyAmong(*around)) continue;
        }
        grid.forEachSpan(part.segments[i], put);
    }
    for (const FacePolygon& polygon : part.uncertain)
        touched->forEachSpan(polygon.all(), [&](int row, int left, int right) {
            places.forEach(row, left, right,
                           [&](Crowded& cell) { cell.uncertain.push_back(polygon); });
        });
    for (const Crowded& cell : crowded) {
        const std::size_t work = cell.segments.size() + cell.uncertain.size();
        if (work > workLeft_) return false;
        workLeft_ -= work;
    }
    return std::all_of(crowded.begin(), crowded.end(), [&](const Crowded& cell) {
        return holds({grid.cell(cell.row, cell.column), part.halvings + depth, cell.segments,
                      cell.uncertain, grid.corner(cell.row, cell.column)},
                     depthFor(cell.segments.size(), leastFiner, mostFiner));
    });
}

} // namespace edgeshade
