#pragma once

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// Coefficients of the terms 1, y, z, x, xy, yz, 3z^2 - 1, xz, x^2 - y^2.
using DiffuseCoefficients = std::array<glm::vec3, 9>;

/// Accumulates the light that a white Lambert surface reflects of its surroundings, in spherical
/// harmonics of bands 0 to 2 (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
/// Environment Maps", 2001).
class DiffuseSum {
  public:
    /// Adds radiance from a direction of unit length. Solid angles may have any unit, as their sum
    /// stands for the sphere.
    void add(const glm::vec3& direction, const glm::vec3& radiance, double solidAngle);

    /// The mean radiance, equal to the mean over all normals of irradiance / pi.
    glm::dvec3 mean() const;

    /// Coefficients of irradiance / pi, as environmentDiffuse() of environment.glsl takes them.
    DiffuseCoefficients coefficients() const;

  private:
    std::array<glm::dvec3, 9> sums_{};
    double solidAngle_ = 0.0;
};

/// The terms of the coefficients at a normal of unit length.
std::array<float, 9> diffuseTerms(const glm::vec3& normal);

} // namespace edgeshade
