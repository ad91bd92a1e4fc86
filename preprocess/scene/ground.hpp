#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// A plane laid beneath a scene.
struct Ground {
    GroundMaterial material = GroundMaterial::catcher; ///< not `none`
    glm::vec3 color{1.0f};                             ///< linear, for a `surface`

    bool operator==(const Ground&) const = default;
};

/// Adds a disc just beneath the whole scene, as the last batch, with its own material, the last
/// one. It is flat, level (y is up), and visible only from above. Its radius is six times that of
/// the scene's ball. The vertices' alpha, by which a catcher fades, falls from 1 at twice the
/// ball's radius to 0 at the rim. Returns false for a scene without vertices, which gets none.
bool addGround(Scene& scene, const Ground& ground);

/// The material of the scene's ground; empty: it has none.
std::optional<std::size_t> groundMaterialOf(const Scene& scene);

/// Gives the scene's ground the material of another ground.
void setGround(Scene& scene, const Ground& ground);

/// Whether the scene has its own floor: surfaces that face up within the lowest tenth of its height
/// cover at least half of its area seen from above. Takes time linear in the triangles.
bool hasFloor(const Scene& scene);

} // namespace edgeshade
