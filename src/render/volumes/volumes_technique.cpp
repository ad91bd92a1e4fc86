#include "src/render/volumes/volumes_technique.hpp"

#include "preprocess/base/error.hpp"
#include "src/render/volumes/grazed_surfaces.hpp"
#include "src/settings/build_parts.hpp"

namespace edgeshade {
namespace {

/// Throws if volumes of this layout can't be counted in the view. Opposite-vertex records and
/// triangles can't where a far plane at a finite depth cuts volumes, or casters are missing from
/// the depth buffer (docs/method.md, C33 and C39).
void requireCountable(VolumeLayout layout, const FrameView& view) {
    if (layout == VolumeLayout::planePairs) return;
    const std::string what =
        layout == VolumeLayout::triangles ? "Brute-force volumes" : "Opposite-vertex records";
    if (view.frustum.orthographic)
        throw Error(ExitStatus::unavailable, what + " can't be counted in an orthographic picture; "
                                                    "'--multiplicity plane' can count them.");
    if (view.culls)
        throw Error(ExitStatus::unavailable,
                    what + " don't store which side of a triangle is its front, so culled "
                           "casters can't be counted; '--multiplicity plane' can count them.");
}

} // namespace

VolumesTechnique::VolumesTechnique(std::unique_ptr<VolumeRenderer> volumes,
                                   const RenderSettings& settings,
                                   const gl::Capabilities& capabilities)
    : volumes_(std::move(volumes)), counter_(capabilities) {
    if constexpr (marksGrazed)
        if (settings.maskScale == 1) grazed_ = std::make_shared<GrazedSurfaces>();
}

VolumesTechnique::~VolumesTechnique() = default;

void VolumesTechnique::beginFrame(const FrameStart& start) {
    requireCountable(volumes_->layout(), start.view);
    volumes_->beginFrame(start.scene, start.mostListed);
}

void VolumesTechnique::beginPrograms(bool directional, bool open) {
    volumes_->beginPrograms(directional, open);
    if constexpr (marksGrazed)
        if (grazed_) grazed_->beginProgram();
}

void VolumesTechnique::forEachProgram(const gl::ProgramVisitor& visit) const {
    volumes_->forEachProgram(visit);
    counter_.forEachProgram(visit);
    if constexpr (marksGrazed)
        if (grazed_) grazed_->forEachProgram(visit);
}

std::size_t VolumesTechnique::stencils(const GpuScene& scene, const FrameLight& light) const {
    return scene.groupCount(light, volumes_->layout());
}

void VolumesTechnique::plan(const GpuScene& scene, const CasterGroupInSlice& casters,
                            CountPlan& plan) {
    volumes_->plan(scene, casters, plan);
}

void VolumesTechnique::prepare(const CountPlan& plan, GpuScene& scene,
                               const CasterGroupInSlice& casters) {
    volumes_->prepare(plan, scene, casters);
}

std::size_t VolumesTechnique::mark(const MarkTask& task) {
    countAlone(task);
    const CasterGroupInSlice& of = task.casters;
    if constexpr (marksGrazed)
        if (grazed_ && of.group == 0) grazed_->mark(task.scene, of.view, of.slice, of.light);
    return task.plan.vertexRuns();
}

void VolumesTechnique::countAlone(const MarkTask& task) const {
    counter_.count(task.plan, *volumes_, task.scene, task.casters);
}

bool VolumesTechnique::marksEverywhere() const {
    return volumes_->layout() != VolumeLayout::planePairs;
}

} // namespace edgeshade
