#pragma once

#include "preprocess/base/function_ref.hpp"
#include "preprocess/base/kept_vector.hpp"
#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/plan/count_plan.hpp"
#include "src/shadow/plan/light_lists.hpp"

namespace edgeshade {

/// The plan for one light in one depth slice.
struct LightPlan {
    glm::dvec4 position{0.0}; ///< the light's; w = 0: the direction towards it
    bool cut = false;         ///< its casters are cut at its depth, FrameLight::cut
    PixelRectangle reach;     ///< the pixels that the light may change; empty: it is not drawn
    /// One plan for each stencil, in order: one in all, or one for each group of casters; empty if
    /// the light's shadows are not volumes.
    KeptVector<CountPlan> counts;
    bool listed = false; ///< without a shadow, and in SlicePlan::lists

    bool isCounted() const { return !counts.empty(); }
    bool inGroups() const { return counts.size() > 1; }
    /// Empties it, and keeps its memory.
    void clear();
};

/// The plan for one depth slice.
struct SlicePlan {
    KeptVector<LightPlan> lights; ///< by index in the view
    PixelRectangle reach;         ///< bounds of all lights' pixels
    /// The first light that reaches something and whose shadows need no alpha of their own. The
    /// stencil is cleared for it together with depth.
    std::optional<std::size_t> first;
    bool withAmbient = false; ///< the first light is drawn together with ambient light
    /// Lights without a shadow that one pass adds up; null if there are fewer than two.
    std::optional<LightLists> lists{};

    /// The stencil's start while depth is drawn.
    StencilStart start() const;
    /// Empties it, and keeps its memory.
    void clear();
};

/// Everything that one frame draws of lights and shadow volumes. Code that draws, explains or shows
/// volumes, or counts their vertices, reads this plan and decides nothing itself.
struct FramePlan {
    KeptVector<SlicePlan> slices; ///< as in the view, from far to near
};

/// The input of planFrame(), with the callbacks that it needs, which must outlive it.
struct FrameTask {
    const FrameView& view;
    PixelRectangle open;       ///< the pixels that may be drawn at all
    bool ownStencil = false;   ///< volumes are counted in another framebuffer than the picture's
    bool ambientApart = false; ///< no light is drawn together with ambient light
    /// Number of groups of the light's casters; 0: its shadows are not volumes.
    FunctionRef<std::size_t(std::size_t light)> groupCount;
    /// Plans one of these groups, into a plan of an earlier frame.
    FunctionRef<void(const DepthSlice&, std::size_t light, std::size_t group, CountPlan&)>
        planCount;
    /// Whether the light has no shadow and may be listed; null: no light may, each takes a pass.
    FunctionRef<bool(std::size_t light)> mayBeListed = {};
    /// listLights(); needed only if lights may be listed.
    LightLists (*list)(std::span<const ReachingLight>, int width, int height) = nullptr;
};

/// Plans for every slice which lights are drawn, on which pixels, which one together with ambient
/// light, and all draws of their shadow volumes. Needs no GL. In a mask that is not a sum, only the
/// first light is drawn. Reuses the memory of `frame`.
void planFrame(const FrameTask& task, FramePlan& frame);

} // namespace edgeshade
