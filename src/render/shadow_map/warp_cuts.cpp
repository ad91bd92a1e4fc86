#include "src/render/shadow_map/warp_cuts.hpp"

#include "src/shadow/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {
namespace {

constexpr int cells = MapWarp::cells;

/// First and last cell between two places along a line of the lattice.
glm::ivec2 cellsBetween(double low, double high) {
    return {std::clamp(static_cast<int>(std::floor(low)), 0, cells - 1),
            std::clamp(static_cast<int>(std::floor(high)), 0, cells - 1)};
}

/// The part of it within a cell; outermost cells go on. Corners are weights, so `along`, the
/// caster's corners' coordinates, is a plane.
Polygon within(Polygon polygon, const glm::dvec3& along, const glm::ivec2& all, int cell,
               double from, double to) {
    if (cell > all[0]) polygon = clipped(polygon, along - from);
    if (cell < all[1]) polygon = clipped(polygon, to - along);
    return polygon;
}

} // namespace

WarpCuts::WarpCuts(const MapWarp& warp) : warp_(warp) {
    affines_.reserve(2 * cells * cells);
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x) {
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

void WarpCuts::add(const std::array<glm::dvec3, 3>& corners, std::vector<WarpedCorner>& to) const {
    const glm::dvec3 x(corners[0].x, corners[1].x, corners[2].x);
    const glm::dvec3 y(corners[0].y, corners[1].y, corners[2].y);
    glm::dvec2 low = warp_.inLattice(glm::dvec2(corners[0])), high = low;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const glm::dvec2 at = warp_.inLattice(glm::dvec2(corners[i]));
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const auto emit = [&](const Polygon& piece, const Affine& affine) {
        const auto corner = [&](std::size_t i) {
            const glm::dvec3& weights = piece.corners[i];
            const glm::dvec3 place =
                weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
            to.push_back({weights, {affine.of(place), place.z}});
        };
        for (std::size_t i = 2; i < piece.count; ++i) {
            corner(0);
            corner(i - 1);
            corner(i);
        }
    };
    Polygon whole;
    for (glm::length_t i = 0; i < 3; ++i) {
        glm::dvec3 weights(0.0);
        weights[i] = 1.0;
        whole.add(weights);
    }
    const glm::ivec2 columns = cellsBetween(low.x, high.x);
    for (int i = columns[0]; i <= columns[1]; ++i) {
        const double left = warp_.line(i).x, right = warp_.line(i + 1).x;
        const Polygon column = within(whole, x, columns, i, left, right);
        if (column.count < 3) continue;
        glm::ivec2 rows = cellsBetween(low.y, high.y);
        if (columns[0] != columns[1]) {
            double lowest = 1e300, highest = -1e300;
            for (std::size_t c = 0; c < column.count; ++c) {
                const double at =
                    warp_.inLattice(glm::dvec2(0.5, glm::dot(y, column.corners[c]))).y;
                lowest = std::min(lowest, at);
                highest = std::max(highest, at);
            }
            rows = cellsBetween(lowest, highest);
        }
        for (int j = rows[0]; j <= rows[1]; ++j) {
            const double bottom = warp_.line(j).y, top = warp_.line(j + 1).y;
            const Polygon cell = within(column, y, rows, j, bottom, top);
            if (cell.count < 3) continue;
            if (warp_.rectilinear) {
                emit(cell, affine(i, j, false));
                continue;
            }
            const glm::dvec3 above = (y - bottom) / (top - bottom) - (x - left) / (right - left);
            emit(clipped(cell, -above), affine(i, j, false));
            emit(clipped(cell, above), affine(i, j, true));
        }
    }
}

} // namespace edgeshade
