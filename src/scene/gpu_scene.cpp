#include "src/scene/gpu_scene.hpp"

namespace edgeshade {

std::size_t GpuScene::shadowBytes() const {
    std::size_t total = 0;
    for (const GpuBatch& batch : batches)
        total += batch.shadow.bytes();
    return total;
}

GpuScene uploadScene(const LoadedScene& loaded, std::optional<SidesLayout> volumes,
                     const gl::Capabilities& capabilities) {
    const Scene& scene = loaded.scene;
    GpuScene gpu{{}, scene.materials, Textures(loaded.document, scene.materials, capabilities)};
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        const Batch& batch = scene.batches[i];
        GpuBatch& uploaded = gpu.batches.emplace_back();
        uploaded.worldFromBatch = batch.worldFromBatch;
        uploaded.surfaces = uploadSurfaces(batch);
        uploaded.shadow.groups = loaded.shadows[i].groups; // they tell maps what casts
        if (!volumes) continue;
        std::vector<glm::vec4> holes;
        if (loaded.settings.castMasked) {
            const Casters casters = castersOf(batch, scene.materials, true);
            holes = capHoles(batch, casters, weldCasters(batch, casters));
        }
        uploaded.shadow = uploadShadow(loaded.shadows[i], holes, *volumes);
    }
    return gpu;
}

GroupedShadow uploadGroups(const LoadedScene& loaded, std::span<const std::uint32_t> groupOf,
                           std::size_t groupCount, SidesLayout layout) {
    GroupedShadow groups;
    for (std::uint32_t g = 0; g < groupCount; ++g) {
        const CasterGroupShadow built =
            groupShadow(loaded.scene, loaded.settings.castMasked, groupOf, g);
        auto& group = groups.emplace_back();
        for (std::size_t i = 0; i < built.shadows.size(); ++i)
            group.push_back(uploadShadow(built.shadows[i], built.holes[i], layout));
    }
    return groups;
}

} // namespace edgeshade
