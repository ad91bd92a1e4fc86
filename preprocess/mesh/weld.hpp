#pragma once

#include "preprocess/base/parallel.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// The order `A < B` of positions (docs/method.md, Terms): lexicographic in (x, y, z).
inline bool orderedBefore(const glm::vec3& a, const glm::vec3& b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

using Triangle = std::array<std::uint32_t, 3>;

/// Triangles over distinct positions. Because the positions are sorted, comparing two indices
/// compares the two positions.
struct WeldedMesh {
    std::vector<glm::vec3> positions;  ///< distinct, sorted by orderedBefore
    std::vector<Triangle> triangles;   ///< three distinct vertices each, winding kept
    std::vector<std::uint32_t> source; ///< index of each triangle among those given
    std::size_t degenerate = 0;        ///< triangles dropped for two vertices at one position
};

/// Welds vertices at exactly equal positions (-0 equals +0) and drops degenerate triangles.
///
/// positions: no NaN; `indices`: three per triangle, all below positions.size().
WeldedMesh weld(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                Threads threads = {});

/// Welds vertices by `alike`, which gives for each the first vertex that it equals. Triangles with
/// two equal vertices are dropped. Positions are sorted too, but different vertices may have equal
/// ones.
WeldedMesh weldAlike(std::span<const glm::vec3> positions, std::span<const std::uint32_t> alike,
                     std::span<const std::uint32_t> indices, Threads threads = {});

/// Moves every position that is closer than `tolerance` (> 0) to an earlier one onto the first
/// such. The result depends only on the positions and their order.
void snapPositions(std::vector<glm::vec3>& positions, double tolerance);

} // namespace edgeshade
