#pragma once

#include "src/render/shadow_map/shadow_map.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// A light map's projections, in double.
///
/// Map space is the space in which the map stores positions. For a point light it has the world's
/// axes, the light as its origin and the range as its unit; the stored distance is the position's
/// length, the same on every face of the cube. For a directional light xy are texture coordinates,
/// of its single map or of an imagined map that all cascades are parts of; z is the distance.
struct ShadowMapView {
    struct Face {
        glm::dmat4 clipFromMap{1.0};
        bool seesScene = true;

        bool operator==(const Face&) const = default;
    };

    glm::dmat4 mapFromWorld{1.0};
    std::vector<Face> faces; ///< cube faces in the order of GL's targets, cascades, or one
    double step = 0.0;       ///< see ShadowMapLookup
    double texel = 0.0;
    double near = 0.0; ///< no caster is nearer to the light, in map space
    double share =
        1.0; ///< share of a texture's width that a point light's face takes; the rest is a margin
    /// Cascades, the finest first: their texture coordinates are a position's xy times this xy,
    /// plus this zw.
    std::vector<glm::dvec4> cascades{};
    double cascadeMargin = 0.0; ///< how far lookups may reach outside, as a share of a cascade's
                                ///< texture
    std::size_t revision = 0;   ///< distinguishes projections that these matrices don't fully
                                ///< describe

    bool operator==(const ShadowMapView&) const = default;
    glm::dvec3 scale() const; ///< map space per world length, along map space's axes
};

/// The casters that a map is fitted to.
struct MapSubject {
    Box bounds;               ///< of the scene, in the world; not empty
    std::vector<Box> casters; ///< boxes around casters, each in its batch's space; empty: `bounds`
    std::vector<glm::dmat4> worldFromCasters; ///< by box
};

/// The view of a lamp: six faces of a cube. Each takes `share` of its texture's width; the rest is
/// a margin. Faces that see nothing within `range` of the lamp are marked. `depthBits`: of the
/// depth buffer that finds each texel's nearest caster.
ShadowMapView pointMapView(const glm::dvec3& light, const Box& bounds, double range, int size,
                           double share, int depthBits);

/// The view of a sun, `towards` it: one map of all casters, or cascades of what `frame` shows.
/// `framed`: xy leave room for a frame of empty texels, for maps without another border.
ShadowMapView sunMapView(const glm::dvec3& towards, const MapSubject& subject,
                         const FrameView& frame, const ShadowMapSettings& settings,
                         bool framed = true);

/// Texels around the content of a sun's map, on each side: filter kernels reach them, and so may
/// the bias.
double frameTexels(const ShadowMapSettings& settings);

} // namespace edgeshade
