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

/// How shadow maps are drawn and sampled.
struct ShadowMapSettings : MapChoices {
    float biasTexels = 1.5f;              ///< in texels, at their size on the receiver
    SoftShadows soft = SoftShadows::none; ///< pcss needs MapKind::cube and MapFilter::compare
    bool facesApart = false; ///< one texture per face, even if the GL can hold a cube in one
    /// Share of light in half shadow that counts as light bleeding through several casters, 0..1;
    /// null: the usual, 0.2 for variance maps, 0.02 for moments.
    std::optional<float> bleeding{};
};

/// The textures of a light's map.
struct MapForm {
    bool parallel = false; ///< the light is a sun
    bool cube = false;     ///< one cube map holds all faces; otherwise each is a flat texture
    int faces = 1;         ///< six for a cube, one for a single map, or the number of cascades

    bool operator==(const MapForm&) const = default;
};

/// Sets uniforms of the receivers' shaders beyond those that all maps have.
class MapUniforms {
  public:
    virtual ~MapUniforms() = default;
    /// `unit`: the first texture unit available.
    virtual void set(const gl::Program& program, int unit) const = 0;
    virtual int units() const = 0; ///< number of units it takes
};

/// A light's finished map, with the data that receivers need to sample it.
struct ShadowMapLookup {
    std::array<gl::Name, 6> textures{}; ///< one for a cube map
    int faces = 0;                      ///< number of flat textures; 0 for a cube map
    /// #defines of the receivers' shaders; they live as long as the pass that drew the map.
    const std::vector<std::string>* defines = nullptr;
    glm::dmat4 mapFromWorld{1.0}; ///< see ShadowMapView
    float step = 0.0f;  ///< distance between texels in the map; for a point light at distance 1
    float texel = 0.0f; ///< the same distance as a length in the world
    float biasTexels = 0.0f;
    bool soft = false; ///< for a light with an extent, in place of maps of its points
    std::optional<PcssLight> pcss{};
    float share = 1.0f;       ///< see ShadowMapView
    glm::vec3 mapScale{1.0f}; ///< map space per world length, along each axis
    /// See ShadowMapView: one for each texture of cascades; otherwise empty.
    std::array<glm::vec4, mostCascades> cascades{};
    std::size_t cascadeCount = 0;
    float cascadeMargin = 0.0f;           ///< see ShadowMapView
    const MapUniforms* further = nullptr; ///< null: nothing beyond what all maps have

    /// Number of texture units that the map takes.
    int units() const { return std::max(faces, 1) + (further ? further->units() : 0); }
};

} // namespace edgeshade
