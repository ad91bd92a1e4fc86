#include "src/shadow/plan/frame_plan.hpp"

#include "src/shadow/view/light_reach.hpp"

namespace edgeshade {
namespace {

void planLight(const FrameTask& task, const DepthSlice& slice, std::size_t light, LightPlan& plan) {
    const FrameLight& of = task.view.lights[light];
    plan.position = of.light.position;
    plan.cut = of.cut.has_value();
    if (!of.drawn) return;
    plan.reach = intersection(task.open, lightReach(task.view, slice, of.light));
    if (plan.reach.empty() || !of.shadowed) return;
    const std::size_t groups = task.groupCount(light);
    for (std::size_t group = 0; group < groups; ++group)
        task.planCount(slice, light, group, plan.counts.add());
}

/// Puts the lights that may be listed into lists, if there are at least two.
void listTogether(const FrameTask& task, SlicePlan& plan) {
    if (!task.mayBeListed || task.view.mask) return;
    std::vector<ReachingLight> listed;
    for (std::size_t i = 0; i < plan.lights.size(); ++i)
        if (!plan.lights[i].reach.empty() && task.mayBeListed(i))
            listed.push_back({i, plan.lights[i].reach});
    if (listed.size() < 2) return;
    for (const ReachingLight& of : listed)
        plan.lights[of.light].listed = true;
    plan.lists = task.list(listed, task.view.width, task.view.height);
}

} // namespace

void LightPlan::clear() {
    position = {};
    cut = false;
    reach = {};
    counts.clear();
    listed = false;
}

void SlicePlan::clear() {
    lights.clear();
    reach = {};
    first.reset();
    withAmbient = false;
    lists.reset();
}

StencilStart SlicePlan::start() const {
    if (!first || lights[*first].counts.empty()) return {};
    return lights[*first].counts.front().start;
}

void planFrame(const FrameTask& task, FramePlan& frame) {
    frame.slices.clear();
    const std::size_t lights = task.view.mask && !task.view.sumsMasks ? 1 : task.view.lights.size();
    for (const DepthSlice& slice : task.view.slices) {
        SlicePlan& plan = frame.slices.add();
        for (std::size_t i = 0; i < lights; ++i) {
            LightPlan& light = plan.lights.add();
            planLight(task, slice, i, light);
            plan.reach = united(plan.reach, light.reach);
        }
        listTogether(task, plan);
        for (std::size_t i = 0; i < lights && !plan.first; ++i) {
            const LightPlan& light = plan.lights[i];
            if (!light.reach.empty() && !light.inGroups() && !light.listed && !task.ownStencil)
                plan.first = i;
        }
        plan.withAmbient = plan.first && !task.view.mask && !task.ambientApart;
    }
}

} // namespace edgeshade
