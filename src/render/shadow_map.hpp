#pragma once

#include "src/gl/objects.hpp"

#include <glm/glm.hpp>

namespace edgeshade {

/// How shadow maps are made and read.
struct ShadowMapSettings {
    int size = 2048;         ///< texels along an edge, of each face of a cube; at least 16
    float biasTexels = 1.5f; ///< in texels as large as they are on the receiver
    int pcf = 1;             ///< compares pcf x pcf texels; odd, 1: a single one
};

enum class ShadowMapKind { point, sun };

/// A light's finished map, with what a receiver needs to look itself up in it.
struct ShadowMapLookup {
    ShadowMapKind kind = ShadowMapKind::point;
    gl::Name texture = 0;         ///< a cube map for a point light
    glm::dmat4 mapFromWorld{1.0}; ///< see ShadowMapView
    float step = 0.0f;            ///< from texel to texel in the map; for a cube at distance 1
    float texel = 0.0f;           ///< the same as a length in the world
    float biasTexels = 0.0f;
    bool masksCast = false; ///< MASK and BLEND surfaces are casters too
};

} // namespace edgeshade
