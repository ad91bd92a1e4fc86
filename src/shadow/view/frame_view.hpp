#pragma once

#include "src/shadow/layers/layer_bound.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/view/frustum.hpp"
#include "src/shadow/view/visible_depth.hpp"

#include <optional>

namespace edgeshade {

/// Neighbouring slices share a thin layer of surfaces, so that rounding leaves no gap between them:
/// up to so many times the far depth.
inline constexpr double sliceOverlap = 1.0001;

/// A part of the view by distance along the viewing direction, drawn with a depth range of its own:
/// what a depth buffer of n bits resolves at z is z^2 / (near * 2^n) (docs/method.md, C26 and C27).
struct DepthSlice {
    double near = 0.1;
    double far = std::numeric_limits<double>::infinity();
};

/// How the depth range is divided.
struct DepthChoice {
    std::optional<double> near; ///< the near plane; nothing: fitted to what is visible
    std::optional<int> slices;  ///< 1 or more; nothing: as many as pay
};

/// What a user asks to see.
struct FrameRequest {
    Frustum frustum;
    int width = 1;
    int height = 1;
    std::vector<Light> lights;
    DepthChoice depth{};
    bool ground = true; ///< the scene's ground is shown, if it has one and the eye is above it
    std::size_t lightSamples = 0; ///< points of each light that has an extent; 0: none has any
};

/// Which light's point a light is.
struct AmongPoints {
    std::size_t light = 0; ///< index in the view that has that light
    LightRegion region;
};

/// One light of a frame.
struct FrameLight {
    Light light;
    LayerBound layers; ///< one group of casters where no stencil can overflow, or nobody has asked
    bool drawn = true;
    /// In orthographic pictures, of a point light among the casters' depths: the plane across the
    /// viewing direction through it, in the world, inside deeper. Casters come in two groups, cut
    /// by it (docs/method.md, C33).
    std::optional<glm::dvec4> cut{};
    bool atRest = true; ///< it may be worth a primitive map
    /// What stands for its extent; empty: it has none. `layers` are around any of them then.
    std::vector<Light> points{};
    std::optional<AmongPoints> among{}; ///< it is one of another light's points
    bool atOnce = false;  ///< of a mask: it is as many of 255 as of its points are seen, by its map
    double weight = 1.0;  ///< its share of one light's part in the picture
    bool shadowed = true; ///< else it shines through what casts, see keepShadowed()

    /// What shadows are counted for.
    std::vector<Light> counted() const { return points.empty() ? std::vector{light} : points; }
    /// How many groups of casters it takes.
    std::size_t groupCount() const { return (cut ? 2 : 1) * layers.groupCount; }
};

/// What one frame shows, with all that is worked out on the CPU for it.
struct FrameView {
    Frustum frustum; ///< with all that there is before the camera, see standingBack()
    int width = 1;
    int height = 1;
    std::vector<FrameLight> lights; ///< at least one, at most mostLights
    Box bounds{};                   ///< of the scene; shadow maps are fitted to it
    std::vector<DepthSlice> slices; ///< from far to near, at least one; orthographic: one
    double farPlane = std::numeric_limits<double>::infinity(); ///< finite where orthographic
    double farthestDepth = 0.0;                                ///< of what is visible
    std::vector<double> nearestDepths;                         ///< of each batch, visiblePart()
    Box visible{}; ///< of what is visible, in the world; empty: nothing is known of it
    Slopes slopes; ///< of what is visible

    bool mask = false;       ///< the lit mask of the first light, not a picture
    bool sumsMasks = false;  ///< of a mask: those of all lights added up, each of them 1 of 255
    bool drawBlended = true; ///< BLEND surfaces are drawn
    bool ground = false;     ///< the ground is
    bool culls = false;      ///< Scene's

    double near() const { return slices.back().near; }
    /// Divides the depth range anew, see divideDepth(). An orthographic picture stays whole.
    void divide(std::optional<int> count);
    /// Camera to clip space, for a slice of it.
    glm::dmat4 clipFromView(const DepthSlice& slice) const {
        return edgeshade::clipFromView(frustum, slice.near, farPlane);
    }
};

constexpr std::size_t stencilLimit = 255; ///< the largest count of an 8-bit stencil

/// Works out the near plane, the depth slices and the stencil layers. Takes time linear in the
/// triangles. `castMasked` as in CasterSettings. An orthographic picture has one slice, since its
/// depths are told apart alike everywhere, which holds the whole scene: no volume is cut by its
/// near plane or its far plane where it matters. Throws Error(usage) for too many lights.
FrameView makeFrameView(const Scene& scene, bool castMasked, const FrameRequest& request);

/// The same without layers, for callers that draw many frames: they keep the scene's `bounds`, and
/// layers (KeptLayers), for as long as neither scene nor lights move.
FrameView makeFrameView(const Scene& scene, const FrameRequest& request, const Box& bounds);

/// Masks that a picture of 8 bits can add up.
inline constexpr std::size_t mostSummed = 255;

/// A view whose picture is the sum of the lit masks of some of a light's points.
FrameView pointsView(const FrameView& view, std::size_t light, std::size_t first,
                     std::size_t count);

/// The same, where the light has a primitive map for all of it, `atOnce` points by one pass each.
FrameView pointsByMapView(const FrameView& view, std::size_t light, std::size_t first,
                          std::size_t count, std::size_t atOnce);

/// A view that has, in place of every light with points, these, each with its share of the light.
FrameView shadedByPoints(const FrameView& view);

/// Divides [near, farthest] into slices of equal ratios, from far to near. `count`: nothing for as
/// many as pay.
std::vector<DepthSlice> divideDepth(double near, double farthest, std::optional<int> count);

/// The near plane as far out as what is visible allows: just before `nearest`, at least 1e-6 of
/// `diagonal`, the size of the scene.
double fittedNear(double nearest, double diagonal);

} // namespace edgeshade
