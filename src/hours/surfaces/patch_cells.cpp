#include "src/hours/surfaces/patch_cells.hpp"

#include "preprocess/base/error.hpp"
#include "src/hours/surfaces/plane_polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace edgeshade::hours {
namespace {

/// Share of a cell by which a patch's rectangle may exceed whole cells, as its rounded floats do.
constexpr double wholeCells = 1e-3;
/// Share of a cell within which a sensor is moved away from a triangle's edge, and share of the way
/// to the middle of the triangle's part by which.
constexpr double nearEdge = 1e-3, awayFromEdge = 1.0 / 128.0;
/// Sine of the slope up to which a patch is level.
constexpr double leastSlope = 0.1;
/// Share of its sides' product below which a triangle has no area on its patch's plane.
constexpr double edgeOn = 1e-12;

[[noreturn]] void failGrid(double width, const std::string& about) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", width);
    throw Error(ExitStatus::usage, std::string("--grid: cells of ") + text + " scene units " +
                                       about + "; take a larger grid, or fewer surfaces.");
}

/// The part of a triangle in one cell.
struct Piece {
    std::uint64_t cell = 0; ///< row by row
    std::uint32_t triangle = 0;
    PlanePolygon polygon;
    double area = 0.0; ///< in the world
};

class PatchGrid {
  public:
    PatchGrid(const Patch& patch, const GridSettings& grid, SurfaceCells& cells)
        : patch_(patch), grid_(grid), to_(cells) {}

    void add() {
        measure();
        for (const std::uint32_t triangle : patch_.triangles)
            divide(triangle);
        std::stable_sort(pieces_.begin(), pieces_.end(),
                         [](const Piece& a, const Piece& b) { return a.cell < b.cell; });
        for (std::size_t first = 0; first < pieces_.size();) {
            std::size_t end = first;
            while (end < pieces_.size() && pieces_[end].cell == pieces_[first].cell)
                ++end;
            addCell(std::span(pieces_).subspan(first, end - first));
            first = end;
        }
    }

  private:
    glm::dvec2 onPlane(const glm::dvec3& point) const {
        const glm::dvec3 way = point - patch_.origin;
        return {glm::dot(way, patch_.right), glm::dot(way, patch_.up)};
    }

    PlanePolygon polygonOf(std::uint32_t t) const {
        const WorldTriangle& triangle = to_.triangles[t];
        return {onPlane(triangle.a), onPlane(triangle.b), onPlane(triangle.c)};
    }

    void measure() {
        low_ = onPlane(to_.triangles[patch_.triangles.front()].a);
        glm::dvec2 high = low_;
        for (const std::uint32_t t : patch_.triangles)
            for (const glm::dvec2& corner : polygonOf(t)) {
                low_ = glm::min(low_, corner);
                high = glm::max(high, corner);
            }
        for (glm::length_t axis = 0; axis < 2; ++axis) {
            const double extent = high[axis] - low_[axis];
            const double count = std::max(1.0, std::ceil(extent / grid_.width - wholeCells));
            if (!(count < 2147483648.0)) failGrid(grid_.width, "are too small for this scene");
            counts_[axis] = static_cast<std::uint64_t>(count);
            size_[axis] = extent / count;
        }
        requireRoom();
    }

    /// Fails before work begins: no fewer cells cover the patch's area.
    void requireRoom() const {
        double area = 0.0;
        for (const std::uint32_t t : patch_.triangles)
            area += areaOf(to_.triangles[t]);
        const double cell = size_.x * size_.y; // 0 for slivers that rounding makes lines
        if (cell > 0.0 && area / cell > mostCells - static_cast<double>(to_.cells.size()))
            failTooMany();
    }

    [[noreturn]] void failTooMany() const {
        failGrid(grid_.width, "are more than " + std::to_string(mostCells));
    }

    double line(glm::length_t axis, std::uint64_t i) const {
        return low_[axis] + size_[axis] * static_cast<double>(i);
    }

    /// The first and the last cell along an axis that the polygon reaches.
    std::array<std::uint64_t, 2> reachOf(const PlanePolygon& polygon, glm::length_t axis) const {
        double low = polygon[0][axis], high = low;
        for (const glm::dvec2& corner : polygon) {
            low = std::min(low, corner[axis]);
            high = std::max(high, corner[axis]);
        }
        const auto numberOf = [&](double at) -> std::uint64_t {
            if (!(size_[axis] > 0.0)) return 0;
            const double i = std::floor((at - low_[axis]) / size_[axis]);
            return static_cast<std::uint64_t>(
                std::clamp(i, 0.0, static_cast<double>(counts_[axis] - 1)));
        };
        std::uint64_t first = numberOf(low), last = numberOf(high);
        // Quotients are rounded; lines decide.
        while (first > 0 && line(axis, first) > low)
            --first;
        while (last + 1 < counts_[axis] && line(axis, last + 1) < high)
            ++last;
        return {first, last};
    }

    void divide(std::uint32_t t) {
        const PlanePolygon whole = polygonOf(t);
        const double onPlaneArea = areaOf(whole), area = areaOf(to_.triangles[t]);
        const double sides = glm::length(whole[1] - whole[0]) * glm::length(whole[2] - whole[0]);
        if (!(onPlaneArea > edgeOn * sides)) return addUndivided(t, whole, area);
        const auto [firstColumn, lastColumn] = reachOf(whole, 0);
        for (std::uint64_t column = firstColumn; column <= lastColumn; ++column) {
            const PlanePolygon strip = cut(whole, 0, column);
            if (strip.empty()) continue;
            const auto [firstRow, lastRow] = reachOf(strip, 1);
            for (std::uint64_t row = firstRow; row <= lastRow; ++row) {
                PlanePolygon part = cut(strip, 1, row);
                const double share = areaOf(part) / onPlaneArea;
                if (share > 0.0)
                    addPiece({row * counts_[0] + column, t, std::move(part), share * area});
            }
        }
    }

    /// The outermost lines don't cut: corners that rounding puts beyond them stay.
    PlanePolygon cut(const PlanePolygon& polygon, glm::length_t axis, std::uint64_t i) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return slabOf(polygon, axis, i == 0 ? -infinity : line(axis, i),
                      i + 1 == counts_[axis] ? infinity : line(axis, i + 1));
    }

    void addUndivided(std::uint32_t t, const PlanePolygon& whole, double area) {
        const glm::dvec2 center = (whole[0] + whole[1] + whole[2]) / 3.0;
        const std::uint64_t column = reachOf({center}, 0)[0], row = reachOf({center}, 1)[0];
        addPiece({row * counts_[0] + column, t, whole, area});
    }

    void addPiece(Piece&& piece) {
        if (to_.cells.size() + pieces_.size() >= 2 * mostCells) failTooMany();
        pieces_.push_back(std::move(piece));
    }

    /// The point of the triangle, in the world, at a place of the plane.
    glm::dvec3 onTriangle(std::uint32_t t, const glm::dvec2& place) const {
        const WorldTriangle& triangle = to_.triangles[t];
        const glm::dvec3 normal = normalOf(triangle);
        const glm::dvec3 point = patch_.origin + place.x * patch_.right + place.y * patch_.up;
        const double slope = glm::dot(normal, patch_.normal);
        if (!(slope > 0.0)) return point;
        return point + (glm::dot(normal, triangle.a - point) / slope) * patch_.normal;
    }

    /// The piece that holds the place, most deeply if several do; null if none does.
    static const Piece* pieceAt(std::span<const Piece> pieces, const glm::dvec2& place) {
        const Piece* best = nullptr;
        double deepest = 0.0;
        for (const Piece& piece : pieces) {
            const double depth = depthIn(piece.polygon, place);
            if (depth < 0.0 || (best && depth <= deepest)) continue;
            best = &piece;
            deepest = depth;
        }
        return best;
    }

    /// From a cell's lower edge to its sensor, along the plane.
    double alongCell() const {
        const double middle = 0.5 * size_.y;
        if (!grid_.rise || patch_.up.y < leastSlope) return middle;
        const double along = *grid_.rise / patch_.up.y;
        return along < size_.y ? along : middle;
    }

    void placeSensor(std::span<const Piece> pieces, Cell& cell) const {
        const std::uint64_t column = pieces.front().cell % counts_[0],
                            row = pieces.front().cell / counts_[0];
        glm::dvec2 place(line(0, column) + 0.5 * size_.x, line(1, row) + alongCell());
        const Piece* piece = pieceAt(pieces, place);
        if (!piece) {
            glm::dvec2 sum(0.0);
            for (const Piece& part : pieces)
                sum += part.area * centerOf(part.polygon);
            place = sum / cell.area;
            piece = pieceAt(pieces, place);
        }
        if (!piece) {
            piece =
                &*std::max_element(pieces.begin(), pieces.end(),
                                   [](const Piece& a, const Piece& b) { return a.area < b.area; });
            place = centerOf(piece->polygon);
        }
        const PlanePolygon triangle = polygonOf(piece->triangle);
        if (depthIn(triangle, place) < nearEdge * std::min(size_.x, size_.y))
            place += awayFromEdge * (centerOf(piece->polygon) - place);
        cell.triangle = piece->triangle;
        cell.normal = glm::normalize(normalOf(to_.triangles[piece->triangle]));
        cell.point = onTriangle(piece->triangle, place) + grid_.offset * cell.normal;
    }

    void addCell(std::span<const Piece> pieces) {
        if (to_.cells.size() >= mostCells) failTooMany();
        Cell cell;
        cell.firstFace = static_cast<std::uint32_t>(to_.faces.size());
        cell.faceCount = static_cast<std::uint32_t>(pieces.size());
        for (const Piece& piece : pieces) {
            cell.area += piece.area;
            to_.faces.push_back({static_cast<std::uint32_t>(to_.corners.size()),
                                 static_cast<std::uint32_t>(piece.polygon.size())});
            for (const glm::dvec2& corner : piece.polygon)
                to_.corners.push_back(onTriangle(piece.triangle, corner));
        }
        placeSensor(pieces, cell);
        to_.cells.push_back(cell);
    }

    const Patch& patch_;
    const GridSettings& grid_;
    SurfaceCells& to_;
    glm::dvec2 low_{0.0}, size_{0.0}; ///< of the first cell; of each
    glm::vec<2, std::uint64_t> counts_{1};
    std::vector<Piece> pieces_;
};

} // namespace

void addPatchCells(const Patch& patch, const GridSettings& grid, SurfaceCells& cells) {
    PatchGrid(patch, grid, cells).add();
}

} // namespace edgeshade::hours
