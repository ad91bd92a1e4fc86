#include "src/rivals/maps/warp_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace edgeshade {
namespace {

/// First and last cell of three positions along an axis of the lattice.
glm::ivec2 cellsBetween(const glm::dvec3& places) {
    const double low = std::min({places.x, places.y, places.z});
    const double high = std::max({places.x, places.y, places.z});
    return {std::clamp(static_cast<int>(std::floor(low)), 0, MapWarp::cells - 1),
            std::clamp(static_cast<int>(std::floor(high)), 0, MapWarp::cells - 1)};
}

/// The part of a caster between two lines of the lattice. Corners of `polygon` are barycentric
/// weights, so that `along`, the coordinates of the caster's corners, acts as a plane.
Polygon betweenLines(const Polygon& polygon, const glm::dvec3& along, const glm::ivec2& all,
                     int cell, double from, double to) {
    const bool cutBelow = cell > all[0], cutAbove = cell < all[1]; // outermost cells are unbounded
    if (!cutBelow) return cutAbove ? clipped(polygon, to - along) : polygon;
    const Polygon rest = clipped(polygon, along - from);
    return cutAbove ? clipped(rest, to - along) : rest;
}

/// The whole caster, as weights of its corners.
Polygon wholeCaster() {
    Polygon whole;
    for (glm::length_t i = 0; i < 3; ++i) {
        glm::dvec3 weights(0.0);
        weights[i] = 1.0;
        whole.add(weights);
    }
    return whole;
}

} // namespace

WarpCuts::WarpCuts(const MapWarp& warp) : warp_(warp) {
    affines_.reserve(2 * MapWarp::cells * MapWarp::cells);
    for (int y = 0; y < MapWarp::cells; ++y)
        for (int x = 0; x < MapWarp::cells; ++x) {
            const glm::dvec2 low(warp.line(x).x, warp.line(y).y);
            const glm::dvec2 size = glm::dvec2(warp.line(x + 1).x, warp.line(y + 1).y) - low;
            const glm::dvec2 first = warp.node(x, y), last = warp.node(x + 1, y + 1);
            const glm::dvec2 right = warp.node(x + 1, y), above = warp.node(x, y + 1);
            for (const bool upper : {false, true}) {
                Affine affine;
                affine.atX = (upper ? last - above : right - first) / size.x;
                affine.atY = (upper ? above - first : last - right) / size.y;
                affine.offset = first - affine.atX * low.x - affine.atY * low.y;
                affines_.push_back(affine);
            }
        }
}

/// One caster to cut.
struct WarpCuts::Cut {
    const std::array<glm::dvec3, 3>& corners;
    glm::dvec3 x, y; ///< lattice coordinates of its corners
    std::vector<WarpedCorner>& to;

    void emit(const Polygon& piece, const Affine& affine) const {
        for (std::size_t i = 2; i < piece.count; ++i)
            for (const std::size_t c : {std::size_t{0}, i - 1, i}) {
                const glm::dvec3& weights = piece.corners[c];
                const glm::dvec3 place =
                    weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
                to.push_back({weights, {affine.of(place), place.z}});
            }
    }
};

void WarpCuts::add(const std::array<glm::dvec3, 3>& corners, std::vector<WarpedCorner>& to) const {
    const Polygon whole = wholeCaster();
    const Cut cut{corners,
                  {corners[0].x, corners[1].x, corners[2].x},
                  {corners[0].y, corners[1].y, corners[2].y},
                  to};
    const glm::dvec3 alongX = inLattice(cut.x, 0), alongY = inLattice(cut.y, 1);
    const glm::ivec2 columns = cellsBetween(alongX), rows = cellsBetween(alongY);
    for (int i = columns[0]; i <= columns[1]; ++i) {
        const double left = warp_.line(i).x, right = warp_.line(i + 1).x;
        const Polygon column = betweenLines(whole, cut.x, columns, i, left, right);
        if (column.count < 3) continue;
        const glm::ivec2 here = columns[0] == columns[1] ? rows : rowsOf(column, cut.y);
        for (int j = here[0]; j <= here[1]; ++j)
            addCell(betweenLines(column, cut.y, here, j, warp_.line(j).y, warp_.line(j + 1).y),
                    {i, j}, cut);
    }
}

/// First and last row of cells of a caster's part.
glm::ivec2 WarpCuts::rowsOf(const Polygon& part, const glm::dvec3& y) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t c = 0; c < part.count; ++c) {
        const double at = glm::dot(y, part.corners[c]);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    return cellsBetween(inLattice({low, high, low}, 1));
}

/// Adds the part of a caster that is in one cell.
void WarpCuts::addCell(const Polygon& part, const glm::ivec2& cell, const Cut& cut) const {
    if (part.count < 3) return;
    if (warp_.rectilinear) {
        cut.emit(part, affine(cell.x, cell.y, false));
        return;
    }
    const double left = warp_.line(cell.x).x, bottom = warp_.line(cell.y).y;
    const glm::dvec3 above = (cut.y - bottom) / (warp_.line(cell.y + 1).y - bottom) -
                             (cut.x - left) / (warp_.line(cell.x + 1).x - left);
    cut.emit(clipped(part, -above), affine(cell.x, cell.y, false));
    cut.emit(clipped(part, above), affine(cell.x, cell.y, true));
}

/// Lattice coordinates of three places, along one axis.
glm::dvec3 WarpCuts::inLattice(const glm::dvec3& along, glm::length_t axis) const {
    glm::dvec3 result;
    for (glm::length_t i = 0; i < 3; ++i)
        result[i] = warp_.inLattice(glm::dvec2(along[i]))[axis];
    return result;
}

} // namespace edgeshade
