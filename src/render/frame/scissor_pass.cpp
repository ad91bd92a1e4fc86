#include "src/render/frame/scissor_pass.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/depth_reading.hpp"
#include "src/shadow/scissors/scissored_plan.hpp"

#include <optional>

namespace edgeshade {
namespace {

/// Nanoseconds that finding rectangles takes a pixel of the picture, and a cluster.
constexpr double ofPixel = 4.0, ofCluster = 15000.0;

/// How many times as long filling must take.
constexpr double leastRatio = 8.0;

std::size_t drawnClusters(const LightPlan& light) {
    std::size_t count = 0;
    for (const CountPlan& plan : light.counts)
        for (const BatchPlan& batch : plan.batches)
            for (const ClusterPlan& drawn : batch.volumes.drawn)
                count += drawn.clusters.count;
    return count;
}

} // namespace

bool ScissorPass::isWanted(const RenderSettings& settings, const gl::Capabilities& capabilities) {
    const auto records = settings.records();
    if (!records || records->volumes != VolumeLayout::planePairs) return false;
    if (settings.silhouette != SilhouetteChoice::proposed || settings.maskScale != 1) return false;
    if (settings.scissors == VolumeScissors::on && !gl::canReadDepth(capabilities))
        throw Error(ExitStatus::unavailable, "This GL can't read depth buffers (GL_NV_read_depth); "
                                             "'--volume-scissors off' does without.");
    return settings.scissors == VolumeScissors::on ||
           (settings.scissors == VolumeScissors::automatic && capabilities.isSoftware() &&
            gl::canReadDepth(capabilities));
}

ScissorPass::ScissorPass(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : always_(settings.scissors == VolumeScissors::on),
      weights_(FillWeights::ofDevice(capabilities.isSoftware())) {}

bool ScissorPass::pays(const LightPlan& light, const FrameView& view,
                       const DepthSlice& slice) const {
    if (!light.isCounted() || light.counts.front().fullyShadowed) return false;
    if (always_) return true;
    const double pixels = static_cast<double>(view.width) * view.height;
    const double least =
        leastRatio * (ofPixel * pixels + ofCluster * static_cast<double>(drawnClusters(light)));
    double fill = 0.0;
    for (const CountPlan& count : light.counts)
        fill += estimatedFill(count, view, slice, light.reach, weights_);
    return fill > least;
}

void ScissorPass::scissor(SlicePlan& plan, const std::vector<Material>& materials,
                          const FrameView& view, const DepthSlice& slice, StageClock* clock) {
    std::optional<StageScope> stage;
    bool known = false;
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        LightPlan& light = plan.lights[i];
        if (!pays(light, view, slice)) continue;
        if (!stage) stage.emplace(clock, FrameStage::volumes);
        if (!known) {
            depths_.width = view.width;
            depths_.height = view.height;
            depths_.bits = gl::readDepth({0, 0, view.width, view.height}, depths_.depths);
            known = depths_.bits > 0;
        }
        if (!known) {
            if (!always_) return;
            throw Error(ExitStatus::unavailable,
                        "A picture with several samples a pixel has no depths that could be read; "
                        "'--volume-scissors off' does without.");
        }
        const VisiblePoints visible(depths_, view, slice, view.lights[i].light, light.reach);
        for (CountPlan& count : light.counts)
            scissorPlan(count, visible, materials, view, slice, weights_);
    }
}

} // namespace edgeshade
