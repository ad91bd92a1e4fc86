#include "src/viewer/viewer_gpu.hpp"

#include "src/render/frame/prepare_scene.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/viewer/side_needs.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

/// Whether a page's worker can build maps of a scene that it knows as it was loaded, without the
/// ground. It cuts the scene as the page does. It doesn't know poses of batches that deform, which
/// are static once they are cut, nor the page's numbers of MASK materials that are cut away and
/// cast: they come after the ground's.
bool isKnownToWorker(const LoadedScene& scene) {
    if (!scene.uncut) return true;
    const Scene& before = scene.uncut->scene;
    const bool deforms = std::any_of(before.batches.begin(), before.batches.end(),
                                     [](const Batch& batch) { return batch.deforms(); });
    const bool masks =
        std::any_of(before.materials.begin(), before.materials.end(),
                    [](const Material& of) { return of.alphaMode == AlphaMode::mask; });
    return !deforms && !(masks && scene.scene.cutFrom->section.shadows == SectionShadows::whole);
}

} // namespace

ViewerGpu::ViewerGpu(const gl::Capabilities& capabilities_, const RenderSettings& settings,
                     std::shared_ptr<PrimitiveMapWorker> mapWorker)
    : capabilities(capabilities_), renderers(settings, capabilities_), convergence(capabilities_),
      smoothing(capabilities_), sampleLights(capabilities_), layout_(settings.layout),
      mapWorker_(std::move(mapWorker)) {}

VolumeTintPass& ViewerGpu::tintOf(const RenderSettings& drawn) {
    if (!tint_ || tintMethod_ != drawn.multiplicity)
        tint_ = std::make_unique<VolumeTintPass>(drawn, capabilities);
    tintMethod_ = drawn.multiplicity;
    return *tint_;
}

VolumeRecords ViewerGpu::recordsOf(const SideSettings& side) const {
    return renderers.base().recordsOf(side.multiplicity, layout_);
}

std::vector<VolumeRecords> ViewerGpu::recordsFor(const ViewState& of) const {
    std::vector<VolumeRecords> records;
    for (const SideSettings* side : {&of.left, &of.right})
        if (mayCount(*side) && (side == &of.left || of.split)) records.push_back(recordsOf(*side));
    if (of.sunHours) records.push_back(recordsOf(hoursSide));
    return records;
}

GpuScene ViewerGpu::uploaded(const LoadedScene& loaded, const ViewState& of,
                             const GpuScene* before) const {
    GpuScene made = uploadScene(loaded, recordsOf(of.left), capabilities, before);
    for (const VolumeRecords& records : recordsFor(of))
        addVolumes(made, loaded, records);
    if (isKnownToWorker(loaded)) made.primitiveMaps.buildWith(mapWorker_);
    return made;
}

void ViewerGpu::addVolumesFor(const ViewState& of, const LoadedScene& loaded) {
    if (!scene) return;
    for (const VolumeRecords& records : recordsFor(of))
        addVolumes(*scene, loaded, records);
}

std::size_t ViewerGpu::shadowBytes() const {
    return (scene ? scene->shadowBytes() : 0) + renderers.volumeBytes() + renderers.maskBytes() +
           convergence.bytes() + smoothing.bytes() + sampleLights.bytes() +
           (hours ? hours->bytes() : 0);
}

} // namespace edgeshade::viewer
