#pragma once

#include "src/shadow/plan/fill_cost.hpp"

namespace edgeshade {

/// pushedTo() of the shaders.
glm::dvec4 pushedTo(const glm::dvec4& end, const glm::dvec3& p, const glm::dvec4& light);

/// The fill of an edge's side that ends at `end`, drawn as the shaders draw it: as one triangle or
/// two.
FillCost sideFill(const FillMeter& meter, const glm::dvec3& a, const glm::dvec3& b,
                  const glm::dvec4& light, const glm::dvec4& end);

} // namespace edgeshade
