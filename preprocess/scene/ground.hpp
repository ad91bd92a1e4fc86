#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// A plane to lay beneath a scene.
struct Ground {
    GroundMaterial material = GroundMaterial::catcher; ///< not `none`
    glm::vec3 color{1.0f};                             ///< of a `surface`, linear

    bool operator==(const Ground&) const = default;
};

/// A round plane just beneath all of the scene, as the last batch, with a material of its own, the
/// last one: flat, level (y is up), seen from above alone. As wide as the scene's ball six times;
/// its vertices' alpha, which a catcher fades by, goes from 1 at twice that to 0 at the rim. A
/// scene without vertices gets none. Returns whether it got one.
bool addGround(Scene& scene, const Ground& ground);

/// Makes the material of a scene's ground that of another ground.
void setGround(Scene& scene, const Ground& ground);

/// Whether the scene has a floor of its own: surfaces that look up within the lowest tenth of its
/// height cover half of what it covers from above, or more. Takes time linear in the triangles.
bool hasFloor(const Scene& scene);

} // namespace edgeshade
