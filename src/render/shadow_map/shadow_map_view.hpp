#pragma once

#include "src/render/shadow_map/map_warp.hpp"
#include "src/render/shadow_map/shadow_map.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// Where a light's map looks from, in double.
///
/// Map space is what the map stores positions in. For a point light it has the world's axes, the
/// light as its origin and the range as its unit, and a position's distance is its length: the same
/// on every face of the cube. For a directional light xy are texture coordinates, of its one map or
/// of an imagined one of which each cascade is a part, or, where it is warped, 0..1 across what
/// casts; z is the distance.
struct ShadowMapView {
    struct Face {
        glm::dmat4 clipFromMap{1.0}; ///< of a paraboloid's halves not asked: its program has it
        bool seesScene = true;

        bool operator==(const Face&) const = default;
    };

    ShadowMapKind kind = ShadowMapKind::point;
    glm::dmat4 mapFromWorld{1.0};
    std::vector<Face> faces; ///< a cube's in the order of GL's targets, halves up and down, or one
    double step = 0.0;       ///< see ShadowMapLookup
    double texel = 0.0;
    double near = 0.0; ///< no caster is nearer to the light, in map space
    double share =
        1.0; ///< of a texture's width, what a point light's face takes; the rest is a margin
    /// Cascades, the finest first: a place's xy, times xy, plus zw, in its texture.
    std::vector<glm::dvec4> cascades{};
    double cascadeMargin = 0.0; ///< what lookups may reach, as a share of a cascade's texture
    std::optional<MapWarp> warp{};

    bool operator==(const ShadowMapView&) const = default;
    glm::dvec3 scale() const; ///< of map space, per length in the world, along its axes
};

/// What a map is fitted to.
struct MapSubject {
    Box bounds;               ///< of the scene, in the world; not empty
    std::vector<Box> casters; ///< boxes around them, each in its batch's space; none: `bounds`
    std::vector<glm::dmat4> worldFromCasters; ///< by box
};

/// The view for a light; of what a light with a range doesn't reach nothing is seen. Cascades are
/// of what `frame` shows, and warps for the places that are `visible`, in the world. `depthBits`:
/// of the buffer that finds each texel's nearest caster.
ShadowMapView shadowMapView(const Light& light, const MapSubject& subject, const FrameView& frame,
                            const ShadowMapSettings& settings, int depthBits,
                            std::span<const glm::dvec3> visible = {});

/// What kind of map the light gets, where the GL holds a cube in one texture.
ShadowMapKind mapKindOf(const Light& light, const ShadowMapSettings& settings);

} // namespace edgeshade
