#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::city {

/// Triangles of a nearly flat polygon with holes. `rings`: the outer one first, then holes, in any
/// sense, without a repeated last corner. GLU's tessellator divides it by the outer ring's normal;
/// where lines cross it adds corners. Triangles run as the outer ring does. Less than three corners
/// or no area: none. Throws Error(unavailable) if memory runs out.
std::vector<std::array<glm::dvec3, 3>>
trianglesOf(const std::vector<std::vector<glm::dvec3>>& rings);

} // namespace edgeshade::city
