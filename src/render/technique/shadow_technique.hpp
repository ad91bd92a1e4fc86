#pragma once

#include "src/render/technique/caster_group.hpp"
#include "src/render/technique/light_method.hpp"
#include "src/render/timing/stage_clock.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/plan/count_plan.hpp"

#include <functional>

namespace edgeshade {

struct ShadowMapLookup;

/// What a technique may need when a frame begins.
struct FrameStart {
    GpuScene& scene;
    const FrameView& view;
    StageClock* clock = nullptr; ///< may be null
    /// Draws how near what is visible is, see Renderer::drawNearness().
    std::function<void(const FrameView&)> drawNearness;
};

/// What is marked in one stencil, and where.
struct MarkTask {
    const GpuScene& scene;
    const CountPlan& plan;
    CasterGroupInSlice casters;
    PixelRectangle reach; ///< pixels that the light reaches, the scissor
    PixelRectangle area;  ///< pixels that any light of the slice reaches
};

/// One way to make the shadows of the lights that a ShadowPolicy gave it. A technique either marks
/// in the stencil what is in shadow (stencils(), plan(), prepare(), mark()), or has surfaces look
/// something up as they are lit (draw(), mapOf(), primitivesOf()). Each frame: beginFrame(); plan()
/// and prepare() for every stencil; then slice by slice beginSlice(), mark() and draw().
class ShadowTechnique {
  public:
    virtual ~ShadowTechnique() = default;

    /// Makes what it needs of a scene that rests, beyond records and primitive maps. Kept for the
    /// scene that was prepared last.
    virtual void prepareScene(const GpuScene&, const LoadedScene&) {}

    /// Throws Error(unavailable) if it can't make shadows in such a view.
    virtual void beginFrame(const FrameStart&) {}
    /// The framebuffer shows other surfaces from now on.
    virtual void beginSlice() {}

    /// How many stencils a light takes, one for each group of casters; 0: it marks none.
    virtual std::size_t stencils(const GpuScene&, const FrameLight&) const { return 0; }
    /// What is drawn into one of them, into the plan of another one. Uploads nothing.
    virtual void plan(const GpuScene&, const CasterGroupInSlice&, CountPlan& plan) { plan.clear(); }
    /// Uploads what the plan draws, and makes its programs, where they are not there yet.
    virtual void prepare(const CountPlan&, GpuScene&, const CasterGroupInSlice&) {}
    /// Leaves what is in shadow in a stencil that was cleared to the plan's start: it is not 0
    /// there. Colour and depth masks, viewport, scissor, depth function (less) and the stencil's
    /// test and function (always) are the caller's state. Returns vertex runs.
    virtual std::size_t mark(const MarkTask&) { return 0; }
    /// Whether that is drawing volumes, whose vertex work can be timed in one pixel.
    virtual bool marksByVolumes() const { return false; }
    /// Draws what mark() would into whatever is there, and nothing else.
    virtual void countAlone(const MarkTask&) const {}
    /// Whether it marks pixels without surfaces, too, so that the picture can't be cut to them.
    virtual bool marksEverywhere() const { return false; }
    /// Whether surfaces that turn away from the light are lit unless their own facing says not.
    virtual bool leavesFacing() const { return false; }

    /// Whether draw() does anything.
    virtual bool drawsLookups() const { return false; }
    /// Draws what the light's surfaces look up; viewport, depth, stencil and blending state are
    /// left changed. Returns vertex runs.
    virtual std::size_t draw(const GpuScene&, const FrameView&, const Light&) { return 0; }
    /// The shadow map that the last draw() made; null: none.
    virtual const ShadowMapLookup* map() const { return nullptr; }
    /// The light's primitive map; null: none.
    virtual const GpuPrimitiveMap* primitivesOf(const GpuScene&, const Light&) const {
        return nullptr;
    }

    /// Says how it makes this light's shadows: what is left as it is, reports say already.
    virtual void describe(const GpuScene&, const Light&, LightMethod&) const {}

    /// Memory on the GPU beyond the scene's.
    virtual std::size_t bytes() const { return 0; }
};

} // namespace edgeshade
