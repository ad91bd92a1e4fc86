#pragma once

#include "src/scene/camera.hpp"

#include <vector>

namespace edgeshade {

/// Distance along the viewing direction to the nearest part of the batch within the picture's
/// pyramid, a little widened; infinity if there is none. Exact but for rounding: triangles are
/// clipped to the pyramid.
double nearestVisibleDepth(const Batch& batch, const Camera& camera, double aspect);

/// The near plane as far out as what is visible allows (method, section 5): just before the
/// nearest of `depths`, at least 1e-6 of `diagonal`, the size of the scene.
double fittedNear(const std::vector<double>& depths, double diagonal);

} // namespace edgeshade
