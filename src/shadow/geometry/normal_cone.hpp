#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade {

/// The normals of some triangles that are visible only from their fronts.
struct NormalCone {
    glm::dvec3 axis{0.0};   ///< of length 1
    double cosine = 1.0;    ///< of the largest angle between the axis and a normal
    double thickness = 0.0; ///< the least of twice a triangle's area by the sum of its sides ab and
                            ///< ac; 0: nothing is known of the triangles
};

/// The cone of one triangle.
NormalCone coneOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// A cone around others; nothing is known of it where it would be as wide as a half space.
NormalCone coneAround(std::span<const NormalCone> cones);

/// A picture's view from another space, to find triangles that show their backs.
class BackView {
  public:
    /// `error`: of placing corners in the view.
    BackView(const glm::dmat4& viewFromSpace, bool orthographic, double error);

    /// Whether showsBack() of batch_in_view.cpp is true for all triangles with these normals whose
    /// corners are within `radius` of `center`. May be false although it is.
    bool showsBacks(const NormalCone& cone, const glm::dvec3& center, double radius) const;

  private:
    glm::dmat4 viewFromSpace_;
    bool orthographic_;
    double error_, scale_ = 0.0, stretch_ = 0.0;
    glm::dmat3 cofactors_{0.0}; ///< times the determinant's sign
};

/// Four cones side by side.
struct FourCones {
    using Lane = std::array<float, 4>;
    std::array<Lane, 3> axis{};
    Lane cosine{}, thickness{};

    /// Rounds the cone so that it becomes wider and thinner, if anything.
    void set(std::size_t lane, const NormalCone& cone);
    NormalCone at(std::size_t lane) const;
};

} // namespace edgeshade
