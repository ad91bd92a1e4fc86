#pragma once

#include "src/viewer/orbit.hpp"

#include <optional>

namespace edgeshade::viewer {

/// The first point of the scene's triangles on the ray, ignoring backs that the scene culls. Takes
/// time linear in the triangles: a few milliseconds for 150,000.
std::optional<glm::dvec3> firstHit(const Scene& scene, const Ray& ray);

} // namespace edgeshade::viewer
