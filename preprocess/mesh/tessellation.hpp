#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace edgeshade {

/// Places inside of loops: those that they wind around an odd number of times, or at all.
enum class WindingRule { odd, nonzero };

/// A polygon in triangles.
struct Tessellation {
    /// Numbers of corners: those of the loops, one loop after the other, then `added`.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<glm::dvec3> added; ///< where lines cross
};

/// Divides a nearly flat polygon into triangles by GLU's tessellator. `loops`: its corners, without
/// a repeated last one. `normal`: of its plane, any length but 0; triangles are counter-clockwise
/// where it points to. Null: memory ran out.
std::optional<Tessellation> tessellate(const std::vector<std::vector<glm::dvec3>>& loops,
                                       const glm::dvec3& normal, WindingRule rule);

} // namespace edgeshade
