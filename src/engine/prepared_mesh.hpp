#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <vector>

namespace edgeshade {

struct PreparedMesh::Data {
    CopyOnWrite<Geometry> geometry; ///< one group, of one of the maskMaterials(), or empty
    std::shared_ptr<const PlanePairShadow> shadow;
    bool alphaTested = false;
    std::vector<glm::vec4> alphaCorners = {}; ///< of the caps, see alphaCorners(); empty if no
                                              ///< caster is alpha-tested

    std::size_t triangles() const { return geometry->indices.size() / 3; }
    /// Only for a mesh with triangles.
    std::size_t material() const { return geometry->groups.front().material; }
};

/// Materials of meshes: casting or only receiving, double-sided or single-sided, with or without
/// alpha test.
std::vector<Material> maskMaterials();

} // namespace edgeshade
