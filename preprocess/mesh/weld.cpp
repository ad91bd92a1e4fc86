#include "preprocess/mesh/weld.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <meshoptimizer.h>
#include <numeric>
#include <unordered_map>

namespace edgeshade {
namespace {

/// Positions with -0 replaced by +0, so that equal means equal bytes.
std::vector<glm::vec3> withoutNegativeZero(std::span<const glm::vec3> positions) {
    std::vector<glm::vec3> result(positions.begin(), positions.end());
    for (glm::vec3& p : result)
        p += 0.0f;
    return result;
}

/// A cell of the snapping grid.
struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        auto hash = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u;
        hash = (hash ^ static_cast<std::uint64_t>(cell.y)) * 0xC2B2AE3D27D4EB4Fu;
        hash = (hash ^ static_cast<std::uint64_t>(cell.z)) * 0x165667B19E3779F9u;
        return static_cast<std::size_t>(hash ^ hash >> 32);
    }
};

/// Which cell of the axis. So far out that floats lie farther apart than cells are wide, only equal
/// coordinates are close: each has a cell of its own there, so that no cell fills up.
std::int64_t cellOf(float coordinate, double size) {
    constexpr double farthest = 0x1p52;
    const double cell = std::floor(static_cast<double>(coordinate) / size);
    if (std::abs(cell) < farthest) return static_cast<std::int64_t>(cell);
    // Neighbours of other floats are not neighbours here.
    std::int32_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);
    return (std::int64_t{1} << 60) + std::int64_t{4} * bits;
}

Cell cellOf(const glm::vec3& position, double size) {
    return {cellOf(position.x, size), cellOf(position.y, size), cellOf(position.z, size)};
}

/// `distinctOf`: what each vertex that triangles use is welded to, numbered as they are met.
WeldedMesh welded(const std::vector<glm::vec3>& positions,
                  const std::vector<std::uint32_t>& distinctOf, std::size_t distinctCount,
                  std::span<const std::uint32_t> indices) {
    WeldedMesh mesh;
    std::vector<glm::vec3> distinct(distinctCount);
    for (const std::uint32_t index : indices)
        distinct[distinctOf[index]] = positions[index];

    // Sort them, so that the order of indices is the order of positions.
    std::vector<std::uint32_t> sorted(distinctCount), rank(distinctCount);
    std::iota(sorted.begin(), sorted.end(), 0u);
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (orderedBefore(distinct[a], distinct[b])) return true;
        return a < b && !orderedBefore(distinct[b], distinct[a]);
    });
    mesh.positions.reserve(distinctCount);
    for (std::uint32_t i = 0; i < distinctCount; ++i) {
        rank[sorted[i]] = i;
        mesh.positions.push_back(distinct[sorted[i]]);
    }

    const std::size_t triangleCount = indices.size() / 3;
    mesh.triangles.reserve(triangleCount);
    mesh.source.reserve(triangleCount);
    for (std::size_t t = 0; t < triangleCount; ++t) {
        Triangle triangle;
        for (std::size_t c = 0; c < 3; ++c)
            triangle[c] = rank[distinctOf[indices[3 * t + c]]];
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
            triangle[2] == triangle[0]) {
            ++mesh.degenerate;
            continue;
        }
        mesh.triangles.push_back(triangle);
        mesh.source.push_back(static_cast<std::uint32_t>(t));
    }
    return mesh;
}

} // namespace

WeldedMesh weld(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    if (indices.empty()) return {};
    const std::vector<glm::vec3> clean = withoutNegativeZero(positions);
    std::vector<std::uint32_t> distinctOf(clean.size());
    const std::size_t distinctCount =
        meshopt_generateVertexRemap(distinctOf.data(), indices.data(), indices.size(), clean.data(),
                                    clean.size(), sizeof(glm::vec3));
    return welded(clean, distinctOf, distinctCount, indices);
}

WeldedMesh weldAlike(std::span<const glm::vec3> positions, std::span<const std::uint32_t> alike,
                     std::span<const std::uint32_t> indices) {
    if (indices.empty()) return {};
    constexpr std::uint32_t unused = 0xFFFFFFFFu;
    std::vector<std::uint32_t> distinctOf(positions.size(), unused);
    std::uint32_t distinctCount = 0;
    for (const std::uint32_t index : indices) {
        std::uint32_t& first = distinctOf[alike[index]];
        if (first == unused) first = distinctCount++;
        distinctOf[index] = first;
    }
    return welded(withoutNegativeZero(positions), distinctOf, distinctCount, indices);
}

void snapPositions(std::vector<glm::vec3>& positions, double tolerance) {
    std::vector<glm::vec3> kept; // in the order of the positions
    std::unordered_map<Cell, std::vector<std::size_t>, CellHash> keptByCell;
    for (glm::vec3& position : positions) {
        const Cell home = cellOf(position, tolerance);
        std::size_t first = kept.size();
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                for (std::int64_t dz = -1; dz <= 1; ++dz) {
                    const auto cell = keptByCell.find({home.x + dx, home.y + dy, home.z + dz});
                    if (cell == keptByCell.end()) continue;
                    for (const std::size_t k : cell->second)
                        if (k < first &&
                            glm::distance(glm::dvec3(kept[k]), glm::dvec3(position)) < tolerance)
                            first = k;
                }
        if (first < kept.size()) {
            position = kept[first];
        } else {
            keptByCell[home].push_back(kept.size());
            kept.push_back(position);
        }
    }
}

} // namespace edgeshade
