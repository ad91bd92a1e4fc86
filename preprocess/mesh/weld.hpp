#pragma once

#include "preprocess/base/parallel.hpp"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace edgeshade {

/// The order `A < B` of positions (docs/method.md, Terms): lexicographic on (x, y, z).
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
    std::vector<Triangle> triangles;   ///< three different vertices each, orientation kept
    std::vector<std::uint32_t> source; ///< which of the given triangles each one was
    std::size_t degenerate = 0;        ///< triangles dropped: two vertices at one position
};

/// Welds vertices at exactly equal positions (-0 equals +0) and drops degenerate triangles.
///
/// positions: no NaN; `indices`: three a triangle, all below positions.size().
WeldedMesh weld(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                Threads threads = {});

/// Welds vertices that are alike, by what `alike` says of each: the first vertex that is like it.
/// Triangles that have two like vertices are dropped. Positions are sorted too, but those of
/// vertices that aren't alike may be equal.
WeldedMesh weldAlike(std::span<const glm::vec3> positions, std::span<const std::uint32_t> alike,
                     std::span<const std::uint32_t> indices, Threads threads = {});

/// Moves every position that is closer than `tolerance` (> 0) to an earlier one onto the first
/// such. The result depends on the order of the positions alone.
void snapPositions(std::vector<glm::vec3>& positions, double tolerance);

} // namespace edgeshade
