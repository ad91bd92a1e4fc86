#pragma once

#include "edgeshade/shadow_masks.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <optional>
#include <vector>

namespace edgeshade {

struct PreparedMesh::Data {
    CopyOnWrite<Geometry> geometry; ///< one group, of one of the maskMaterials(), or empty; a
                                    ///< clipped mesh may have a second, hidden one
    std::shared_ptr<const PlanePairShadow> shadow;
    bool alphaTested = false;
    std::vector<glm::vec4> alphaCorners = {}; ///< of the caps, see alphaCorners(); empty if no
                                              ///< caster is alpha-tested

    std::size_t triangles() const { return geometry->indices.size() / 3; }
    /// Only for a mesh with triangles.
    std::size_t material() const { return geometry->groups.front().material; }
};

inline constexpr std::size_t maskMaterialCount = 16;

/// Materials of meshes: casting or only receiving, double-sided or single-sided, with or without
/// alpha test, visible or not.
std::vector<Material> maskMaterials();

/// Whether masks don't show a material of that number.
bool isHidden(std::size_t material);

/// The number of a material's counterpart that casts and is invisible; none if it doesn't cast.
std::optional<std::size_t> hiddenMaterial(std::size_t material);

/// Finds the edges of a geometry whose groups are of the maskMaterials(). `solid`: whether to look
/// for closed solids, which takes time.
std::shared_ptr<const PreparedMesh::Data> preparedFrom(Geometry geometry, bool testsAlpha,
                                                       bool solid);

} // namespace edgeshade
