#pragma once

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
/// of an imagined one of which each cascade is a part; z is the distance.
struct ShadowMapView {
    struct Face {
        glm::dmat4 clipFromMap{1.0};
        bool seesScene = true;

        bool operator==(const Face&) const = default;
    };

    glm::dmat4 mapFromWorld{1.0};
    std::vector<Face> faces; ///< a cube's in the order of GL's targets, cascades, or one
    double step = 0.0;       ///< see ShadowMapLookup
    double texel = 0.0;
    double near = 0.0; ///< no caster is nearer to the light, in map space
    double share =
        1.0; ///< of a texture's width, what a point light's face takes; the rest is a margin
    /// Cascades, the finest first: a place's xy, times xy, plus zw, in its texture.
    std::vector<glm::dvec4> cascades{};
    double cascadeMargin = 0.0; ///< what lookups may reach, as a share of a cascade's texture
    std::size_t revision = 0;   ///< tells projections apart that are more than these matrices

    bool operator==(const ShadowMapView&) const = default;
    glm::dvec3 scale() const; ///< of map space, per length in the world, along its axes
};

/// What a map is fitted to.
struct MapSubject {
    Box bounds;               ///< of the scene, in the world; not empty
    std::vector<Box> casters; ///< boxes around them, each in its batch's space; none: `bounds`
    std::vector<glm::dmat4> worldFromCasters; ///< by box
};

/// The view of a lamp: six faces of a cube, of which each takes `share` of its texture's width, a
/// margin the rest. Faces that see nothing within `range` of the lamp are marked. `depthBits`: of
/// the buffer that finds each texel's nearest caster.
ShadowMapView pointMapView(const glm::dvec3& light, const Box& bounds, double range, int size,
                           double share, int depthBits);

/// The view of a sun, `towards` it: one map of all casters, or cascades of what `frame` shows.
/// `framed`: xy leave room for a frame of empty texels, as maps need that nothing else puts around
/// them.
ShadowMapView sunMapView(const glm::dvec3& towards, const MapSubject& subject,
                         const FrameView& frame, const ShadowMapSettings& settings,
                         bool framed = true);

/// Texels around what a sun's map shows, on each side: a kernel reaches them, and so may bias.
double frameTexels(const ShadowMapSettings& settings);

} // namespace edgeshade
