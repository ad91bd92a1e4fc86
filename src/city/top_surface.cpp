#include "src/city/top_surface.hpp"

#include <algorithm>

namespace edgeshade::city {
namespace {

__extension__ using Wide = __int128;
using Units = std::array<glm::vec<3, std::int64_t>, 3>;

/// A triangle's height over a point: base + above / over, in lattice units. `over` is above 0.
struct Height {
    std::int64_t base, over;
    Wide above;

    /// The sign of this minus the other. With coordinates below 2^23 and heights below 2^25, the
    /// products are below 2^121.
    int compare(const Height& other) const {
        const Wide difference =
            Wide(base - other.base) * over * other.over + above * other.over - other.above * over;
        return difference > 0 ? 1 : difference < 0 ? -1 : 0;
    }
};

/// Corners relative to a vertical line; heights as they are.
Units cornersFrom(const CityTriangle& triangle, std::int64_t x, std::int64_t y) {
    Units corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& corner = triangle.corners[i];
        corners[i] = {unitsOf(corner.x) - x, unitsOf(corner.y) - y, unitsOf(corner.z)};
    }
    return corners;
}

/// The height where the line meets the triangle, edges included; null: it doesn't.
std::optional<Height> heightOf(const Units& corners) {
    const auto& [a, b, c] = corners;
    const auto weightOf = [](const auto& from, const auto& to) {
        return from.x * to.y - from.y * to.x;
    };
    std::int64_t ofA = weightOf(b, c), ofB = weightOf(c, a), ofC = weightOf(a, b);
    std::int64_t sum = ofA + ofB + ofC;
    if (sum == 0) return std::nullopt;
    if (sum < 0) {
        ofA = -ofA;
        ofB = -ofB;
        ofC = -ofC;
        sum = -sum;
    }
    if (ofA < 0 || ofB < 0 || ofC < 0) return std::nullopt;
    return Height{a.z, sum, Wide(ofB) * (b.z - a.z) + Wide(ofC) * (c.z - a.z)};
}

/// An order of triangles by their corners alone.
bool isBefore(const CityTriangle& a, const CityTriangle& b) {
    const auto sorted = [](const CityTriangle& triangle) {
        std::array<std::array<double, 3>, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3& corner = triangle.corners[i];
            corners[i] = {corner.x, corner.y, corner.z};
        }
        std::ranges::sort(corners);
        return corners;
    };
    return sorted(a) < sorted(b);
}

/// The cells [first, end) of a row or column whose middles lie between two coordinates, and perhaps
/// one more on each side.
std::pair<std::int64_t, std::int64_t> cellsBetween(double low, double high, double width,
                                                   std::int64_t first, std::int64_t end) {
    const auto at = [&](double value) {
        return static_cast<std::int64_t>(std::floor(value / width - 0.5));
    };
    return {std::max(first, at(low) - 1), std::min(end, at(high) + 3)};
}

} // namespace

std::vector<std::uint32_t> topSurfaces(std::span<const CityTriangle> triangles,
                                       const CellRange& cells, double width) {
    std::vector<std::uint32_t> tops(cells.count(), noSurface);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const Box box = triangles[t].box();
        const auto [left, right] =
            cellsBetween(box.low.x, box.high.x, width, cells.left, cells.right);
        const auto [bottom, top] =
            cellsBetween(box.low.y, box.high.y, width, cells.bottom, cells.top);
        for (std::int64_t j = bottom; j < top; ++j) {
            const double y = middleOf(j, width);
            if (y < box.low.y || y > box.high.y) continue;
            for (std::int64_t i = left; i < right; ++i) {
                const double x = middleOf(i, width);
                if (x < box.low.x || x > box.high.x) continue;
                const std::int64_t atX = unitsOf(x), atY = unitsOf(y);
                const std::optional<Height> height = heightOf(cornersFrom(triangles[t], atX, atY));
                if (!height) continue;
                std::uint32_t& best = tops[static_cast<std::size_t>(
                    (j - cells.bottom) * cells.columns() + i - cells.left)];
                if (best == noSurface) {
                    best = t;
                    continue;
                }
                const int above =
                    height->compare(*heightOf(cornersFrom(triangles[best], atX, atY)));
                if (above > 0 || (above == 0 && isBefore(triangles[t], triangles[best]))) best = t;
            }
        }
    }
    return tops;
}

double heightAt(const CityTriangle& triangle, double x, double y) {
    const Height height = *heightOf(cornersFrom(triangle, unitsOf(x), unitsOf(y)));
    return latticeUnit * (static_cast<double>(height.base) +
                          static_cast<double>(height.above) / static_cast<double>(height.over));
}

} // namespace edgeshade::city
