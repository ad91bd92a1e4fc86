#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/render/shadow_map/shadow_map.hpp"
#include "src/shadow/geometry/light.hpp"

#include <vector>

namespace edgeshade {

/// Where a light's map looks from, in double.
///
/// Map space is what the map stores positions in. For a point light it has the world's axes, the
/// light as its origin and the range as its unit, and a position's distance is its length: the same
/// on every face of the cube. For a directional light xy are texture coordinates and z is the
/// distance.
struct ShadowMapView {
    struct Face {
        glm::dmat4 clipFromMap{1.0};
        bool seesScene = true;
    };

    ShadowMapKind kind = ShadowMapKind::point;
    glm::dmat4 mapFromWorld{1.0};
    std::vector<Face> faces; ///< six in the order of GL's cube map targets, or one
    double step = 0.0;       ///< see ShadowMapLookup
    double texel = 0.0;
    double near = 0.0; ///< no caster is nearer to the light, in map space
};

/// The view for a light and the scene's bounds, which must not be empty; of what a light with a
/// range doesn't reach nothing is seen. `depthBits`: of the buffer that finds each texel's nearest
/// caster.
ShadowMapView shadowMapView(const Light& light, const Box& bounds,
                            const ShadowMapSettings& settings, int depthBits);

} // namespace edgeshade
