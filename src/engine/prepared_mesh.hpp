#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <vector>

namespace edgeshade {

struct PreparedMesh::Data {
    CopyOnWrite<Geometry> geometry; ///< one group of maskMaterials(), or empty
    std::shared_ptr<const PlanePairShadow> shadow;
};

/// What meshes are made of: those that cast, and those that don't, seen from both sides or one.
std::vector<Material> maskMaterials();

} // namespace edgeshade
