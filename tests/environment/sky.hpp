#pragma once

#include "src/environment/environment.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade::test {

/// Radiance for a direction of unit length.
using Sky = std::function<glm::dvec3(const glm::dvec3& direction)>;

/// A coloured and asymmetric sky, in which all axes differ, with a soft sun of 16.
glm::dvec3 lopsidedSky(const glm::dvec3& direction);

/// Directions evenly over the sphere, including the axes and places near the seams of octahedral
/// maps.
std::vector<glm::vec3> testDirections();

/// Irradiance / pi, summed over the hemisphere.
glm::dvec3 lambertByBruteForce(const Sky& sky, const glm::dvec3& normal);

/// The split sum's first factor, summed over the hemisphere: GGX's distribution of the half vector
/// times the cosine, divided by its own integral.
glm::dvec3 ggxByBruteForce(const Sky& sky, const glm::dvec3& normal, double roughness);

/// The mean over the sphere.
glm::dvec3 meanOf(const Sky& sky);

} // namespace edgeshade::test
