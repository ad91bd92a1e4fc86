#pragma once

#include "preprocess/base/function_ref.hpp"
#include "preprocess/base/kept_vector.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/plan/count_plan.hpp"
#include "src/shadow/plan/light_lists.hpp"

namespace edgeshade {

/// What is done for one light in one depth slice.
struct LightPlan {
    PixelRectangle reach; ///< the pixels that it may change; empty: it is not drawn
    /// What is counted for it, one stencil after the other: one, or one for each group of casters;
    /// none where its shadows are no volumes.
    KeptVector<CountPlan> counts;
    bool listed = false; ///< without a shadow, in SlicePlan::lists

    bool isCounted() const { return !counts.empty(); }
    bool inGroups() const { return counts.size() > 1; }
    /// Empties it, and keeps its memory.
    void clear();
};

/// What is done in one depth slice.
struct SlicePlan {
    KeptVector<LightPlan> lights; ///< by index in the view
    PixelRectangle reach;         ///< around those of all lights
    /// The first light that reaches something and whose shadows need no alpha of their own: the
    /// stencil is cleared for it together with depth.
    std::optional<std::size_t> first;
    bool withAmbient = false; ///< that light is drawn together with ambient light
    /// Lights without a shadow that one pass adds up; nothing where there aren't two of them.
    std::optional<LightLists> lists{};

    /// Where the stencil starts as depth is drawn.
    StencilStart start() const;
    /// Empties it, and keeps its memory.
    void clear();
};

/// Everything that one frame draws of lights and shadow volumes. What draws, counts vertices,
/// explains or shows volumes reads this and decides nothing.
struct FramePlan {
    KeptVector<SlicePlan> slices; ///< as the view's, from far to near
};

/// What is planned, with what it needs of others, which must outlive it.
struct FrameTask {
    const FrameView& view;
    PixelRectangle open;       ///< the pixels that may be drawn at all
    bool ownStencil = false;   ///< volumes are counted in another framebuffer than the picture's
    bool ambientApart = false; ///< no light is drawn together with ambient light
    /// How many groups the casters of the light with that index come in; 0: its shadows
    /// are no volumes.
    FunctionRef<std::size_t(std::size_t light)> groupCount;
    /// Plans what is counted of one of the groups, into a plan of an earlier frame.
    FunctionRef<void(const DepthSlice&, std::size_t light, std::size_t group, CountPlan&)>
        planCount;
    /// Whether that light has no shadow and may be listed; null: none may, each takes a pass.
    FunctionRef<bool(std::size_t light)> mayBeListed = {};
    /// listLights(), where lights may be.
    LightLists (*list)(std::span<const ReachingLight>, int width, int height) = nullptr;
};

/// Plans for every slice which lights are drawn, where, together with what, and all draws of their
/// shadow volumes. Needs no GL. In a mask that is no sum only the first light is drawn.
FramePlan planFrame(const FrameTask& task);

/// The same into `frame`, whose memory it reuses.
void planFrame(const FrameTask& task, FramePlan& frame);

} // namespace edgeshade
