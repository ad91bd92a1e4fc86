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

/// How frames are drawn; fixed for a renderer, but for `ambient`, `exposure` and
/// `background`.
struct RenderSettings {
    ShadowMethod shadows = ShadowMethod::volumes;
    MultiplicityMethod multiplicity = MultiplicityMethod::plane;
    SilhouetteChoice silhouette = SilhouetteChoice::proposed; ///< of plane-pair records
    SidesLayout layout = SidesLayout::instanced;
    BruteForceCount count = BruteForceCount::zFail; ///< of brute-force volumes
    std::size_t planes = 4; ///< where shadows are planar: onto how many, see settings::planes
    ShadowMapSettings map;  ///< where shadows are maps
    PrimitiveMapSettings primitiveMap; ///< where they are primitive maps
    bool tintPrimitives = false;       ///< show what texels of those hold
    int maskScale = 1; ///< where they are volumes: counted once for so many by so many pixels
    std::optional<std::size_t> shadowedLights; ///< keepShadowed()'s; nothing: all have shadows
    std::size_t lightSamples = 64; ///< points of a light that has an extent, 1..mostLightPoints
    Shading shading = Shading::base;
    float ambient = 0.35f; ///< 0..1, as the display shows it; the lights share the rest
    /// What ambient light is where shading is full; null: the neutral one.
    std::shared_ptr<const Environment> environment;
    bool softTerminator = false; ///< of full shading: see shaders_es2/terminator.glsl
    float exposure = 0.0f;       ///< of full shading, in EV: light is taken 2^exposure times
    glm::vec3 background{0.86f, 0.89f, 0.92f};
    const Rivals* rivals = nullptr; ///< methods beyond the library's; null: there are none

    /// How many points of each light that has an extent are counted; 0: its map knows better.
    std::size_t countedPoints() const {
        return shadows == ShadowMethod::map && map.soft != SoftShadows::none ? 0 : lightSamples;
    }

    bool looksUpPrimitives() const { return policy().asksForLookups(); }

    /// What a ShadowPolicy has to know of them; a scene's see-through surfaces are another matter.
    PolicySettings policy() const {
        return {.asked = shadows,
                .planePairs = volumeLayoutOf(multiplicity) == VolumeLayout::planePairs,
                .maskScale = maskScale};
    }

    /// What volumes are drawn from; nothing where there are none.
    std::optional<VolumeRecords> records() const {
        if (shadows != ShadowMethod::volumes && !looksUpPrimitives()) return std::nullopt;
        return recordsOf(multiplicity, layout);
    }

    /// The records that volumes of that multiplicity are drawn from.
    VolumeRecords recordsOf(MultiplicityMethod method, SidesLayout sides) const {
        const VolumeLayout volumes = volumeLayoutOf(method);
        return {volumes, sides, rivals ? rivals->records(volumes) : nullptr};
    }
};

} // namespace edgeshade
