#pragma once

#include "src/gl/objects.hpp"
#include "src/gl/program.hpp"
#include "src/render/shadow_map/pcss_light.hpp"
#include "src/settings/choices.hpp"

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// How shadow maps are made and read.
struct ShadowMapSettings : MapChoices {
    float biasTexels = 1.5f;              ///< in texels as large as they are on the receiver
    SoftShadows soft = SoftShadows::none; ///< pcss: of MapKind::cube and MapFilter::compare
    bool facesApart = false; ///< a cube's faces apart even where the GL holds them in one texture
    /// Share of light in half shadow that counts as bleeding through several casters, 0..1;
    /// nothing: the usual 0.2 for variance maps, 0.02 for moments.
    std::optional<float> bleeding{};
};

/// The textures of a light's map.
struct MapForm {
    bool parallel = false; ///< the light is a sun
    bool cube = false;     ///< all faces are in one cube map; else each is a flat texture
    int faces = 1;         ///< six of a cube, one of a single map, or cascades

    bool operator==(const MapForm&) const = default;
};

/// Sets what receivers' shaders read of a map beyond what all maps have.
class MapUniforms {
  public:
    virtual ~MapUniforms() = default;
    /// `unit`: the first texture unit that they may take.
    virtual void set(gl::Program& program, int unit) const = 0;
    virtual int units() const = 0; ///< how many they take
};

/// A light's finished map, with what a receiver needs to look itself up in it.
struct ShadowMapLookup {
    std::array<gl::Name, 6> textures{}; ///< of a cube map one
    int faces = 0;                      ///< how many textures; of a cube map 0
    /// #defines of the receivers' shaders; they live as long as what drew the map.
    const std::vector<std::string>* defines = nullptr;
    glm::dmat4 mapFromWorld{1.0}; ///< see ShadowMapView
    float step = 0.0f;  ///< from texel to texel in the map; of a point light's at distance 1
    float texel = 0.0f; ///< the same as a length in the world
    float biasTexels = 0.0f;
    bool soft = false; ///< of a light with an extent, instead of maps of its points
    std::optional<PcssLight> pcss{};
    float share = 1.0f;       ///< see ShadowMapView
    glm::vec3 mapScale{1.0f}; ///< map space per length in the world, along each axis
    /// See ShadowMapView: one for each texture of cascades; else none.
    std::array<glm::vec4, mostCascades> cascades{};
    std::size_t cascadeCount = 0;
    float cascadeMargin = 0.0f;           ///< see ShadowMapView
    const MapUniforms* further = nullptr; ///< null: all maps' are enough

    /// How many texture units they take.
    int units() const { return std::max(faces, 1) + (further ? further->units() : 0); }
};

} // namespace edgeshade
