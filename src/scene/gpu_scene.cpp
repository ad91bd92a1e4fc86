#include "src/scene/gpu_scene.hpp"
#include "src/settings/build_parts.hpp"

#include <algorithm>
#include <map>

namespace edgeshade {
namespace {

/// A batch's welded casters; needed only if casters may be alpha-tested.
struct HoleSource {
    Casters casters;
    CasterMesh mesh;
};

std::optional<HoleSource> holeSource(const LoadedScene& loaded, const Batch& batch) {
    if (!loaded.mayHaveHoles()) return std::nullopt;
    HoleSource source{castersOf(batch, loaded.scene.materials, loaded.settings.castMasked), {}};
    source.mesh = weldForRecords(batch, source.casters);
    return source;
}

void addPlanePairs(GpuScene& gpu, const LoadedScene& loaded, SidesLayout layout) {
    const auto made = byGeometry(loaded.scene.batches, [&](std::size_t i) {
        if (gpu.batches[i].volumes.planePairs) return gpu.batches[i].volumes.planePairs;
        const Batch& batch = loaded.scene.batches[i];
        const auto& shadow = loaded.planePairs[i];
        const auto source = holeSource(loaded, batch);
        return std::make_shared<PlanePairBuffers>(
            shadow,
            source ? alphaCorners(batch, source->casters, source->mesh, *shadow)
                   : std::vector<glm::vec4>(),
            layout);
    });
    for (std::size_t i = 0; i < gpu.batches.size(); ++i)
        gpu.batches[i].volumes.planePairs = made[i];
}

/// Sets GpuBatch::geometry.
void keepGeometry([[maybe_unused]] GpuBatch& of, [[maybe_unused]] const Batch& batch) {
    if constexpr (keepsGeometry) of.geometry = batch.geometry;
}

void addFurther(GpuScene& gpu, const LoadedScene& loaded, const VolumeRecords& records) {
    const auto made = records.source->ofScene(loaded, records.layout);
    for (std::size_t i = 0; i < gpu.batches.size(); ++i)
        gpu.batches[i].volumes.further.push_back({records, made[i]});
}

} // namespace

std::size_t GpuScene::groupCount(const FrameLight& light, VolumeLayout layout) const {
    const GroupedShadow* of = groups.of(light, layout);
    return of ? of->size() : 1;
}

BatchVolumes& GpuScene::volumesOf(std::size_t batch, const FrameLight& light, VolumeLayout layout,
                                  std::size_t group) {
    if (GroupedShadow* of = groups.of(light, layout)) return (*of)[group][batch];
    return batches[batch].volumes;
}

const BatchVolumes& GpuScene::volumesOf(std::size_t batch, const FrameLight& light,
                                        VolumeLayout layout, std::size_t group) const {
    if (const GroupedShadow* of = groups.of(light, layout)) return (*of)[group][batch];
    return batches[batch].volumes;
}

std::size_t GpuScene::shadowBytes() const {
    std::size_t total = 0;
    for (const GpuBatch& batch : batches)
        if (batch.owns) total += batch.volumes.bytes();
    return total + groups.sideBytes() + groups.capBytes();
}

namespace {

/// A scene's batches by their records, for the scene under another section.
class KnownBatches {
  public:
    KnownBatches(const GpuScene* scene, const std::optional<VolumeRecords>& records) {
        if (!scene || !records || records->volumes != VolumeLayout::planePairs) return;
        for (const GpuBatch& batch : scene->batches) {
            const auto& volumes = batch.volumes.planePairs;
            if (volumes && volumes->layout() == records->layout)
                known_.emplace(volumes->shadow().get(), &batch);
        }
    }

    const GpuBatch* of(const PlanePairShadow& records) const {
        const auto found = known_.find(&records);
        return found != known_.end() ? found->second : nullptr;
    }

  private:
    std::map<const PlanePairShadow*, const GpuBatch*> known_;
};

} // namespace

GpuScene uploadScene(const LoadedScene& loaded, std::optional<VolumeRecords> records,
                     const gl::Capabilities& capabilities, const GpuScene* before) {
    const Scene& scene = loaded.scene;
    const KnownBatches known(before, records);
    GpuScene gpu{{},
                 {},
                 {},
                 scene.materials,
                 before ? before->textures : Textures(loaded, capabilities),
                 loaded.settings.castMasked,
                 loaded.cutoutsCast};
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Batch& batch = scene.batches[i];
        GpuBatch& made = gpu.batches.emplace_back();
        made.worldFromBatch = batch.worldFromBatch;
        made.animated = batch.isAnimated();
        made.ground = batch.ground;
        made.hidden = batch.hidden;
        keepGeometry(made, batch);
        made.owns = first[i] == i;
        const GpuBatch* const same = known.of(*loaded.planePairs[i]);
        if (same) {
            made.surfaces = same->surfaces;
            made.volumes.planePairs = same->volumes.planePairs;
            continue;
        }
        made.surfaces = made.owns ? std::make_shared<std::vector<SurfaceChunk>>(
                                        uploadSurfaces(batch, scene.materials))
                                  : gpu.batches[first[i]].surfaces;
    }
    gpu.plain = true;
    for (const GpuBatch& batch : gpu.batches)
        for (const SurfaceChunk& chunk : *batch.surfaces) {
            const Material& material = gpu.materials[chunk.material];
            if (!material.isSeen()) continue;
            const bool blends = material.alphaMode == AlphaMode::blend;
            gpu.seeThrough = gpu.seeThrough || (blends && !material.unlit);
            gpu.plain = gpu.plain && (material.unlit || blends || material.isPlain());
        }
    for (std::size_t i = 0; i < scene.batches.size(); ++i)
        if (scene.batches[i].deforms()) gpu.batches[i].parts = surfacePartsOf(scene.batches[i]);
    if (records) addVolumes(gpu, loaded, *records);
    return gpu;
}

void uploadShape(GpuScene& gpu, const LoadedScene& loaded, std::size_t batch) {
    GpuBatch& to = gpu.batches[batch];
    const Batch& from = loaded.scene.batches[batch];
    uploadShape(from, gpu.materials, to.parts, *to.surfaces);
    keepGeometry(to, from);
    BatchVolumes& volumes = to.volumes;
    if (volumes.planePairs) volumes.planePairs->take(loaded.planePairs[batch]);
    for (FurtherRecords& of : volumes.further)
        of.buffers = of.made.source->ofBatch(loaded, from, of.made.layout);
}

void addVolumes(GpuScene& gpu, const LoadedScene& loaded, VolumeRecords records) {
    if (std::all_of(gpu.batches.begin(), gpu.batches.end(),
                    [&](const GpuBatch& batch) { return batch.volumes.has(records.volumes); }))
        return;
    if (records.volumes == VolumeLayout::planePairs)
        addPlanePairs(gpu, loaded, records.layout);
    else if (records.source)
        addFurther(gpu, loaded, records);
}

} // namespace edgeshade
