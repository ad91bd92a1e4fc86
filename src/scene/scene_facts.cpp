#include "src/scene/scene_facts.hpp"

#include "src/gl/float_table.hpp"
#include "src/scene/build_parts.hpp"
#include "src/shadow/silhouette/count_silhouettes.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

std::size_t silhouettesOf(const LoadedScene& loaded, const Light& light) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        count +=
            countSilhouettes(*loaded.planePairs[i],
                             glm::inverse(loaded.scene.batches[i].worldFromBatch) * light.position);
    return count;
}

bool anyAlphaTested(const PlanePairShadow& shadow) {
    return std::ranges::any_of(shadow.clusters, &ShadowCluster::alphaTested);
}

} // namespace

DeviceFacts deviceFactsOf(const gl::Capabilities& capabilities) {
    return {.floatTables = gl::hasFloatTables(capabilities),
            .textureUnits = capabilities.textureUnits,
            .fragmentUniformVectors = capabilities.fragmentUniformVectors,
            .isSoftware = capabilities.isSoftware(),
            .hasDepthOfItsOwn = hasPoints && capabilities.has("GL_OES_packed_depth_stencil"),
            .samples = capabilities.samples};
}

SceneFacts sceneFactsOf(const LoadedScene& loaded) {
    const std::vector<Batch>& batches = loaded.scene.batches;
    const auto isAnimated = [](const Batch& batch) { return batch.isAnimated(); };
    return {
        .triangles = loaded.scene.triangleCount(),
        .anyAnimated = std::ranges::any_of(batches, isAnimated),
        .allAnimated = !batches.empty() && std::ranges::all_of(batches, isAnimated),
        .simplified = std::ranges::any_of(
            batches, [](const Batch& of) { return of.geometry->simplifiedCasters.has_value(); }),
        .alphaTested = std::ranges::any_of(
            loaded.planePairs, [](const auto& shadow) { return anyAlphaTested(*shadow); }),
        .cutoutsCast = loaded.cutoutsCast};
}

LightFacts lightFactsOf(const Light& light, const LoadedScene& loaded) {
    return {.hasExtent = light.extent.has_value(),
            .hasRange = light.hasRange(),
            .isSpot = light.isSpot(),
            .silhouetteEdges = [&loaded, light] { return silhouettesOf(loaded, light); }};
}

std::size_t restingEdges(const LoadedScene& loaded) {
    std::size_t edges = 0;
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        if (!loaded.scene.batches[i].isAnimated())
            edges += loaded.planePairs[i]->pairs.size() + loaded.planePairs[i]->singles.size();
    return edges;
}

} // namespace edgeshade
