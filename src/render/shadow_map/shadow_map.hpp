#pragma once

#include "src/gl/objects.hpp"
#include "src/render/shadow_map/pcss_light.hpp"

#include <array>
#include <glm/glm.hpp>
#include <optional>

namespace edgeshade {

/// What lights with an extent get of their shadow maps.
enum class SoftShadows {
    none, ///< hard shadows of their points, each with a map, added up
    pcf,  ///< the map of their centre, filtered as wide as any
    pcss, ///< percentage-closer soft shadows (Fernando 2005) of the map of their centre
};

/// How shadow maps are made and read.
struct ShadowMapSettings {
    int size = 2048;         ///< texels along an edge, of each face of a cube; at least 16
    float biasTexels = 1.5f; ///< in texels as large as they are on the receiver
    int pcf = 1;             ///< compares pcf x pcf texels; odd, 1: a single one
    SoftShadows soft = SoftShadows::none;
    bool facesApart = false; ///< a cube's faces apart even where the GL holds them in one texture
};

enum class ShadowMapKind {
    point,       ///< a cube map
    pointApart,  ///< six textures for a cube's faces, where the GL can't hold them in one
    directional, ///< one parallel projection
};

/// A light's finished map, with what a receiver needs to look itself up in it.
struct ShadowMapLookup {
    ShadowMapKind kind = ShadowMapKind::point;
    std::array<gl::Name, 6> textures{}; ///< six where the faces are apart, else one
    glm::dmat4 mapFromWorld{1.0};       ///< see ShadowMapView
    float step = 0.0f;  ///< from texel to texel in the map; for a cube at distance 1
    float texel = 0.0f; ///< the same as a length in the world
    float biasTexels = 0.0f;
    bool soft = false; ///< of a light with an extent, instead of maps of its points
    std::optional<PcssLight> pcss{};
};

} // namespace edgeshade
