#pragma once

#include <array>
#include <glm/glm.hpp>

namespace edgeshade {

/// Coefficients of 1, y, z, x, xy, yz, 3z^2 - 1, xz, x^2 - y^2.
using DiffuseCoefficients = std::array<glm::vec3, 9>;

/// Adds up what light from all around does to a white Lambert surface, in spherical harmonics of
/// bands 0 to 2 (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment
/// Maps", 2001).
class DiffuseSum {
  public:
    /// Radiance from a direction of unit length; the solid angle in any unit, all together are the
    /// sphere.
    void add(const glm::vec3& direction, const glm::vec3& radiance, double solidAngle);

    /// The mean radiance, which is the mean over all normals of irradiance / pi.
    glm::dvec3 mean() const;

    /// Irradiance / pi, as environmentDiffuse() evaluates it.
    DiffuseCoefficients coefficients() const;

  private:
    std::array<glm::dvec3, 9> sums_{};
    double solidAngle_ = 0.0;
};

/// The terms that the coefficients belong to, at a normal of unit length.
std::array<float, 9> diffuseTerms(const glm::vec3& normal);

} // namespace edgeshade
