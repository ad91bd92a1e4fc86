#pragma once

#include "preprocess/mesh/components.hpp"
#include "preprocess/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace edgeshade {

/// For each triangle of a geometry, whether it bounds a solid: a closed component of opaque
/// casters. `topology`: of all its triangles; where they are all opaque casters, it is used, or
/// found if it is null.
std::vector<std::uint8_t> solidTriangles(const Geometry& geometry,
                                         const std::vector<Material>& materials,
                                         std::optional<MeshTopology>& topology);

} // namespace edgeshade
