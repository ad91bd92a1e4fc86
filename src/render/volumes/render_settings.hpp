#pragma once

#include "preprocess/scene/material.hpp"
#include "src/environment/environment.hpp"
#include "src/policy/shadow_policy.hpp"
#include "src/render/shadow_map/shadow_map.hpp"
#include "src/render/technique/rivals.hpp"
#include "src/scene/batch_volumes.hpp"
#include "src/settings/choices.hpp"
#include "src/shadow/primitive_map/primitive_map.hpp"

#include <memory>
#include <optional>

namespace edgeshade {

/// How frames are drawn. Fixed for a renderer, except `ambient`, `exposure` and `background`.
struct RenderSettings {
    ShadowMethod shadows = ShadowMethod::volumes;
    MultiplicityMethod multiplicity = MultiplicityMethod::plane;
    SilhouetteChoice silhouette = SilhouetteChoice::proposed; ///< for plane-pair records
    SidesLayout layout = SidesLayout::instanced;
    BruteForceCount count = BruteForceCount::zFail; ///< for brute-force volumes
    std::size_t planes = 4;            ///< planar shadows: number of planes, see settings::planes
    ShadowMapSettings map;             ///< for shadow maps
    PrimitiveMapSettings primitiveMap; ///< for primitive maps
    bool tintPrimitives = false;       ///< show the contents of primitive maps' texels
    int maskScale = 1;                 ///< n: volumes are counted once for each n by n pixels
    std::optional<std::size_t> shadowedLights; ///< keepShadowed()'s; null: all lights have shadows
    std::size_t lightSamples = 64; ///< points of a light with an extent, 1..mostLightPoints
    Shading shading = Shading::base;
    float ambient = 0.35f; ///< 0..1, as displayed; the lights share the rest
    /// The environment of ambient light in full shading; null: the neutral one.
    std::shared_ptr<const Environment> environment;
    bool softTerminator = false; ///< full shading only: see shaders_es2/terminator.glsl
    float exposure = 0.0f;       ///< full shading only, in EV: light is scaled by 2^exposure
    glm::vec3 background{0.86f, 0.89f, 0.92f};
    const Rivals* rivals = nullptr; ///< methods beyond the library's; null: none

    /// Number of points counted for each light with an extent; 0: a soft map replaces counting.
    std::size_t countedPoints() const {
        return shadows == ShadowMethod::map && map.soft != SoftShadows::none ? 0 : lightSamples;
    }

    bool looksUpPrimitives() const { return policy().asksForLookups(); }

    /// The part that a ShadowPolicy needs. A scene's see-through surfaces come from elsewhere.
    PolicySettings policy() const {
        return {.asked = shadows,
                .planePairs = volumeLayoutOf(multiplicity) == VolumeLayout::planePairs,
                .maskScale = maskScale};
    }

    /// The records that volumes are drawn from; null if there are no volumes.
    std::optional<VolumeRecords> records() const {
        if (shadows != ShadowMethod::volumes && !looksUpPrimitives()) return std::nullopt;
        return recordsOf(multiplicity, layout);
    }

    /// The records for volumes with that multiplicity method.
    VolumeRecords recordsOf(MultiplicityMethod method, SidesLayout sides) const {
        const VolumeLayout volumes = volumeLayoutOf(method);
        return {volumes, sides, rivals ? rivals->records(volumes) : nullptr};
    }
};

} // namespace edgeshade
