#pragma once

#include "src/environment/environment.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::test {

/// Radiance by direction of unit length.
using Sky = std::function<glm::dvec3(const glm::dvec3& direction)>;

/// Coloured and lopsided: no axis of it is like another. A soft sun of 16 is in it.
glm::dvec3 lopsidedSky(const glm::dvec3& direction);

/// Evenly over the sphere, the axes among them and what lies near the seams of octahedral maps.
std::vector<glm::vec3> testDirections();

/// Irradiance / pi by adding up the hemisphere.
glm::dvec3 lambertByBruteForce(const Sky& sky, const glm::dvec3& normal);

/// The split sum's first factor: GGX's distribution of the half vector times the cosine over its
/// own integral, by adding up the hemisphere.
glm::dvec3 ggxByBruteForce(const Sky& sky, const glm::dvec3& normal, double roughness);

/// The mean over the sphere.
glm::dvec3 meanOf(const Sky& sky);

} // namespace edgeshade::test
