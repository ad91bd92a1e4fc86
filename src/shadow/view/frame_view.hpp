#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/layers/layer_bound.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/view/frustum.hpp"
#include "src/shadow/view/visible_depth.hpp"

#include <optional>
#include <span>

namespace edgeshade {

/// Overlap of neighbouring slices as a factor of the far depth. They share a thin layer of
/// surfaces, so that rounding leaves no gap between them.
inline constexpr double sliceOverlap = 1.0001;

/// A part of the view by distance along the viewing direction, drawn with its own depth range: a
/// depth buffer of n bits resolves z^2 / (near * 2^n) at z (docs/method.md, C26 and C27).
struct DepthSlice {
    double near = 0.1;
    double far = std::numeric_limits<double>::infinity();
};

/// Division of the depth range.
struct DepthChoice {
    std::optional<double> near; ///< the near plane; null: fitted to the visible geometry
    std::optional<int> slices;  ///< 1 or more; null: as many as pay
};

/// The view and the lights that a user requests.
struct FrameRequest {
    Frustum frustum;
    int width = 1;
    int height = 1;
    std::vector<Light> lights;
    DepthChoice depth{};
    bool ground = true; ///< show the scene's ground, if it has one and the eye is above it
    std::size_t lightSamples = 0; ///< points of each light with an extent; 0: ignore extents
    bool nearestDepths = true;    ///< fill in FrameView::nearestDepths, batch by batch
};

/// Identifies the light of which this one is a point.
struct AmongPoints {
    std::size_t light = 0; ///< index in the view that has the whole light
    LightRegion region;
};

/// One light of a frame.
struct FrameLight {
    Light light;
    LayerBound layers; ///< a single group if no stencil can overflow, or if not computed
    bool drawn = true;
    /// For a point light among the casters' depths in an orthographic picture: the plane through it
    /// across the viewing direction, in the world, positive at larger depths. It cuts casters into
    /// two groups (docs/method.md, C33).
    std::optional<glm::dvec4> cut{};
    bool atRest = true;         ///< it may be worth a primitive map
    bool animatedAlone = false; ///< only animated casters are counted: a host looks up the others
    /// Points that stand for its extent; empty: it has none. `layers` then hold for all of them.
    std::vector<Light> points{};
    std::optional<AmongPoints> among{}; ///< set if it is a point of another light
    bool atOnce = false; ///< in a mask: adds the number of its visible points, of 255, by its
                         ///< primitive map
    std::optional<std::size_t> number{}; ///< by which renderers know it from frame to frame; null:
                                         ///< its index in the view
    double weight = 1.0;                 ///< its share of one light's contribution to the picture
    bool shadowed = true;                ///< otherwise casters don't block it, see keepShadowed()

    /// The lights whose shadows are counted.
    std::span<const Light> counted() const {
        return points.empty() ? std::span(&light, 1) : std::span(points);
    }
    /// Number of groups of casters that it needs.
    std::size_t groupCount() const { return (cut ? 2 : 1) * layers.groupCount; }
    /// Makes it as new, and keeps its memory.
    void clear();
};

/// A frame to draw, with all that the CPU computes for it.
struct FrameView {
    Frustum frustum; ///< has the whole scene in front of the camera, see standingBack()
    int width = 1;
    int height = 1;
    std::vector<FrameLight> lights; ///< at least one, at most mostLights
    Box bounds{};                   ///< of the scene; shadow maps are fitted to it
    std::vector<DepthSlice> slices; ///< from far to near, at least one; orthographic: exactly one
    double farPlane = std::numeric_limits<double>::infinity(); ///< finite if orthographic
    double farthestDepth = 0.0;                                ///< of the visible geometry
    /// The least depth of each batch, see nearestDepth(); empty: unknown.
    std::vector<double> nearestDepths;
    Box visible{}; ///< of the visible geometry, in the world; empty: unknown
    Slopes slopes; ///< of the visible geometry

    bool mask = false;                    ///< draw the lit mask of the first light, not a picture
    bool sumsMasks = false;               ///< in a mask: add up those of all lights, each 1 of 255
    bool drawBlended = true;              ///< draw BLEND surfaces
    bool ground = false;                  ///< draw the ground
    bool culls = false;                   ///< as in Scene
    std::optional<PixelRectangle> part{}; ///< the only pixels that are drawn; null: all
    /// In a mask of a single slice whose lights count animated casters alone: the framebuffer's
    /// depth is that of the surfaces, and stays.
    bool depthDrawn = false;

    double near() const { return slices.back().near; }
    std::size_t numberOf(std::size_t light) const { return lights[light].number.value_or(light); }
    /// Makes it as new, and keeps the memory of its arrays.
    void clear();
    /// Divides the depth range again, see divideDepth(). An orthographic picture stays undivided.
    void divide(std::optional<int> count);
    /// Whether casters of the batch may be before the slice's near plane.
    bool mayMeetNear(std::size_t batch, const DepthSlice& slice) const {
        return nearestDepths.empty() || nearestDepths[batch] <= slice.near;
    }
    /// Transform from camera to clip space, for one of the slices.
    glm::dmat4 clipFromView(const DepthSlice& slice) const {
        return edgeshade::clipFromView(frustum, slice.near, farPlane);
    }
};

constexpr std::size_t stencilLimit = 255; ///< the largest count of an 8-bit stencil

/// Computes the near plane and the depth slices; KeptLayers fills in the stencil layers. Callers
/// that draw many frames keep the scene's `bounds` and its tree while it doesn't move. An
/// orthographic picture has one slice, as its depth resolution is uniform. The slice holds the
/// whole scene: its near and far planes cut no volume where it matters. Throws Error(usage) for too
/// many lights.
FrameView makeFrameView(const Scene& scene, const FrameRequest& request, const Box& bounds,
                        const SceneTree& tree);

/// The same into `view`, whose memory it reuses.
void makeFrameView(const Scene& scene, const FrameRequest& request, const Box& bounds,
                   const SceneTree& tree, FrameView& view);

/// The same with a tree of its own, for a single frame.
FrameView makeFrameView(const Scene& scene, const FrameRequest& request, const Box& bounds);

/// Most masks that an 8-bit picture can add up.
inline constexpr std::size_t mostSummed = 255;

/// A view of one of the lights, which keeps its number.
FrameView aloneView(const FrameView& view, std::size_t light);

/// A view whose picture is the sum of the lit masks of `count` points of a light.
FrameView pointsView(const FrameView& view, std::size_t light, std::size_t first,
                     std::size_t count);

/// The same for a light with a primitive map for its whole extent, with `atOnce` points per pass.
FrameView pointsByMapView(const FrameView& view, std::size_t light, std::size_t first,
                          std::size_t count, std::size_t atOnce);

/// A view in which every light with points is replaced by these, each with its share of the light.
FrameView shadedByPoints(const FrameView& view);

/// Divides [near, farthest] into slices of equal ratios, from far to near. `count`: null for as
/// many as pay.
void divideDepth(double near, double farthest, std::optional<int> count,
                 std::vector<DepthSlice>& slices);

/// The farthest near plane that the visible geometry allows: just before `nearest`, at least 1e-6
/// of `diagonal`, the size of the scene.
double fittedNear(double nearest, double diagonal);

} // namespace edgeshade
