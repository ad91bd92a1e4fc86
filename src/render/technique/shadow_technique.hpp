#pragma once

#include "src/gl/program.hpp"
#include "src/render/technique/caster_group.hpp"
#include "src/render/technique/light_method.hpp"
#include "src/render/timing/stage_clock.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/plan/count_plan.hpp"

#include <functional>

namespace edgeshade {

struct ShadowMapLookup;

/// Data that a technique may need at the start of a frame.
struct FrameStart {
    GpuScene& scene;
    const FrameView& view;
    StageClock* clock = nullptr; ///< may be null
    /// Draws the nearness of visible geometry, see Renderer::drawNearness().
    std::function<void(const FrameView&)> drawNearness;
    /// As of PotentialSilhouettes::beginFrame().
    std::size_t mostListed = PotentialSilhouettes::unlimited;
};

/// A stencil to mark, and where.
struct MarkTask {
    const GpuScene& scene;
    const CountPlan& plan;
    CasterGroupInSlice casters;
    PixelRectangle reach; ///< pixels that the light reaches, the scissor
    PixelRectangle area;  ///< pixels that any light of the slice reaches
};

/// One way to make the shadows of the lights that a ShadowPolicy assigns to it. A technique either
/// marks shadow in the stencil (stencils(), plan(), prepare(), mark()), or provides a map that
/// surfaces sample as they are lit (draw(), map(), primitivesOf()). In each frame: beginFrame();
/// plan() and prepare() for every stencil; then for each slice beginSlice(), mark() and draw().
class ShadowTechnique {
  public:
    virtual ~ShadowTechnique() = default;

    /// Makes what it needs of a scene at rest, beyond records and primitive maps. Kept for the
    /// scene prepared last.
    virtual void prepareScene(const GpuScene&, const LoadedScene&) {}

    /// Throws Error(unavailable) if it can't make shadows in such a view.
    virtual void beginFrame(const FrameStart&) {}
    /// Called when the framebuffer shows other surfaces.
    virtual void beginSlice() {}

    /// Begins to make, ahead of the first frame, programs that most closed casters take;
    /// `directional`: of directional lights, too; `open`: those of open casters, too.
    virtual void beginPrograms([[maybe_unused]] bool directional, [[maybe_unused]] bool open) {}
    /// Visits the programs made or begun so far that frames may take.
    virtual void forEachProgram(const gl::ProgramVisitor&) const {}

    /// Number of stencils that a light takes, one for each group of casters; 0: it marks none.
    virtual std::size_t stencils(const GpuScene&, const FrameLight&) const { return 0; }
    /// Plans the draws into one of them, into an earlier plan, whose memory it may reuse. Uploads
    /// nothing.
    virtual void plan(const GpuScene&, const CasterGroupInSlice&, CountPlan& plan) { plan.clear(); }
    /// Uploads the records that the plan draws, and makes its programs, if they are missing.
    virtual void prepare(const CountPlan&, GpuScene&, const CasterGroupInSlice&) {}
    /// Marks shadow in a stencil that was cleared to the plan's start: it is not 0 there. Colour
    /// and depth masks, viewport, scissor, depth function (less) and the stencil's test and
    /// function (always) are the caller's state. Returns vertex runs.
    virtual std::size_t mark(const MarkTask&) { return 0; }
    /// Whether mark() counts in the stencil, so that its vertex work can be timed in a single
    /// pixel.
    virtual bool countsInStencil() const { return false; }
    /// Draws what mark() draws into the current buffers, and does nothing else.
    virtual void countAlone(const MarkTask&) const {}
    /// Whether it also marks pixels without surfaces, so that drawing can't be limited to visible
    /// pixels.
    virtual bool marksEverywhere() const { return false; }
    /// Whether it leaves surfaces that face away from the light lit, so that only their own normals
    /// can darken them.
    virtual bool leavesFacing() const { return false; }

    /// Whether draw() does anything.
    virtual bool drawsMap() const { return false; }
    /// Draws what the light's surfaces sample; changes viewport, depth, stencil and blending state.
    /// Returns vertex runs.
    virtual std::size_t draw(const GpuScene&, const FrameView&, const Light&) { return 0; }
    /// The shadow map that the last draw() made; null: none.
    virtual const ShadowMapLookup* map() const { return nullptr; }
    /// The light's primitive map; null: none.
    virtual const GpuPrimitiveMap* primitivesOf(const GpuScene&, const Light&) const {
        return nullptr;
    }

    /// Describes how it makes this light's shadows. Fields that it leaves alone keep the reports'
    /// defaults.
    virtual void describe(const GpuScene&, const Light&, LightMethod&) const {}

    /// Memory on the GPU beyond the scene's.
    virtual std::size_t bytes() const { return 0; }
};

} // namespace edgeshade
