#pragma once

#include "src/lab/oracle.hpp"

#include <optional>
#include <span>
#include <vector>

namespace edgeshade::lab {

/// For each direction, in the world, whether the point sees it: no caster is in the way, and its
/// normal, which is not 0, faces the direction. Without a normal every direction counts as faced.
/// The surface under the point doesn't block it, nor do triangles in the same plane. With a normal,
/// a surface that the point touches but with another facing does block. `oracle`: of the scene,
/// with any camera and no lights.
std::vector<bool> seenFrom(const Oracle& oracle, const glm::dvec3& point,
                           const std::optional<glm::dvec3>& normal,
                           std::span<const glm::dvec3> directions);

} // namespace edgeshade::lab
