#include "src/shadow/layers/face_bound.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

// Depths of grids: a face's first one, and those of crowded cells.
constexpr int coarsest = 2, finest = 6, leastFiner = 1, mostFiner = 4;
constexpr std::size_t segmentsPerCell = 48; ///< in a grid with the right depth
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

void FaceBound::begin(std::size_t limit) {
    limit_ = static_cast<int>(limit);
    most_ = 0;
}

bool FaceBound::holds(const FaceChain& face, const Outline& part, int start) {
    start += face.everywhere;
    if (start > limit_ || !std::isfinite(face.error)) return false;
    most_ = std::max(most_, start);
    if (part.empty()) return true;
    error_ = face.error;
    workLeft_ = leastWork + workPerSegment * face.segments.size();
    return holds({part, 0, face.segments, face.uncertain, start, false},
                 depthFor(face.segments.size(), coarsest, finest), 0);
}

bool FaceBound::holds(const Part& part, int depth, std::size_t nesting) {
    if (levels_.size() == nesting) levels_.emplace_back();
    Level& level = levels_[nesting];
    WindingGrid& grid = level.grid;
    grid.begin(part.outline, depth, error_);
    grid.add(part.segments, level.placeOf);
    grid.sum(part.start, part.isRaised);
    const bool touches = !part.uncertain.empty();
    if (touches) {
        level.touched.begin(part.outline, depth);
        for (const FacePolygon& polygon : part.uncertain)
            level.touched.add(polygon.all());
        level.touched.sum();
    }

    const int side = grid.side();
    CrowdedParts& crowded = level.crowded;
    crowded.begin(side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const int bound = grid.bound(row, column) +
                              (touches ? static_cast<int>(level.touched.count(row, column)) : 0);
            if (bound <= limit_)
                most_ = std::max(most_, bound);
            else if (grid.corner(row, column) > limit_)
                return false; // finer grids would have the same corner
            else
                crowded.add(row, column);
        }
    if (crowded.cells().empty()) return true;
    if (part.halvings + depth >= mostHalvings) return false;

    crowded.place();
    for (std::size_t i = 0; i < part.segments.size(); ++i) {
        const FaceSegment& segment = part.segments[i];
        // One test that is nearly always false, whatever the place.
        const int place = level.placeOf[i];
        if (!crowded.anyInSquare(place >= 0 ? place : WindingGrid::inSquare(place))) continue;
        if (place >= 0) {
            crowded.put(place, segment);
            continue;
        }
        if (place == grid.elsewhere()) {
            const auto around = grid.cellsAround(segment);
            if (!around || !crowded.anyAmong(*around)) continue;
        }
        grid.forEachSpan(
            segment, [&](int row, int left, int right) { crowded.put(row, left, right, segment); });
    }
    for (const FacePolygon& polygon : part.uncertain)
        level.touched.forEachSpan(polygon.all(), [&](int row, int left, int right) {
            crowded.put(row, left, right, polygon);
        });
    crowded.sort();
    const std::vector<CrowdedParts::Cell>& cells = crowded.cells();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t work = crowded.segmentsOf(i).size() + crowded.uncertainOf(i).size();
        if (work > workLeft_) return false;
        workLeft_ -= work;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto [row, column] = cells[i];
        const std::span<const FaceSegment> segments = crowded.segmentsOf(i);
        const bool sharesStart = row == 0 && column == 0;
        const Part cell{grid.cell(row, column), part.halvings + depth,    segments,
                        crowded.uncertainOf(i), grid.corner(row, column), sharesStart};
        if (!holds(cell, depthFor(segments.size(), leastFiner, mostFiner), nesting + 1))
            return false;
    }
    return true;
}

} // namespace edgeshade
