#pragma once

#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace edgeshade {

/// For each triangle of a geometry, whether it bounds a solid: a closed component of opaque
/// casters.
std::vector<std::uint8_t> solidTriangles(const Geometry& geometry,
                                         const std::vector<Material>& materials);

} // namespace edgeshade
