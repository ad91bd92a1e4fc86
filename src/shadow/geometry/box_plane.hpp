#pragma once

#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// A GL's relative error in the placement of vertices, as it computes in floats.
constexpr double placingError = 4e-6;

/// The largest of dot(plane, (p, w)) over a box.
double largestOver(const Box& box, const glm::dvec4& plane, double w = 1.0);

/// The plane with this normal that touches the box, with the box on its inner side.
glm::dvec4 planeAround(const Box& box, const glm::dvec3& normal);

/// Bound of the rounding error of dot(plane, (p, 1)) for points p of the box.
double roundingOf(const Box& box, const glm::dvec4& plane);

/// Whether the whole box is certainly outside the plane.
bool isOutside(const Box& box, const glm::dvec4& plane);

/// Whether a box in the world and a placed one are certainly apart along an axis of the world. An
/// empty box in the world is apart from none.
bool areApart(const Box& inWorld, const Box& placed, const glm::dmat4& worldFromPlaced);

/// Whether a light or an eye, homogeneous, is certainly outside the box.
bool isOutsideOf(const Box& box, const glm::dvec4& point);

} // namespace edgeshade
