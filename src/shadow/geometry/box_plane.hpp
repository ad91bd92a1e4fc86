#pragma once

#include "preprocess/scene/scene.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// What a GL may place wrongly, as a share of the coordinates: it places things in floats.
constexpr double placingError = 4e-6;

/// The largest of dot(plane, (p, w)) over a box.
double largestOver(const Box& box, const glm::dvec4& plane, double w = 1.0);

/// What rounding may do to dot(plane, (p, 1)) of a point p of the box.
double roundingOf(const Box& box, const glm::dvec4& plane);

/// Whether the whole box is certainly outside the plane.
bool isOutside(const Box& box, const glm::dvec4& plane);

/// Whether a light or an eye, homogeneous, is certainly outside of the box.
bool isOutsideOf(const Box& box, const glm::dvec4& point);

} // namespace edgeshade
