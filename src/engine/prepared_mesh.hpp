#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <vector>

namespace edgeshade {

struct PreparedMesh::Data {
    CopyOnWrite<Geometry> geometry; ///< one group of maskMaterials(), or empty
    std::shared_ptr<const PlanePairShadow> shadow;
    bool alphaTested = false;
    std::vector<glm::vec4> alphaCorners = {}; ///< of the caps, see alphaCorners(); empty where
                                              ///< nothing that casts is alpha-tested
};

/// What meshes are made of: those that cast or only receive, seen from both sides or one, with
/// alpha tests or without.
std::vector<Material> maskMaterials();

} // namespace edgeshade
