#include "src/scene/scene_facts.hpp"

#include "src/gl/float_table.hpp"
#include "src/settings/build_parts.hpp"
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
    return std::any_of(shadow.clusters.begin(), shadow.clusters.end(),
                       [](const ShadowCluster& cluster) { return cluster.alphaTested; });
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
    SceneFacts facts;
    facts.triangles = loaded.scene.triangleCount();
    facts.allAnimated = !loaded.scene.batches.empty();
    for (const Batch& batch : loaded.scene.batches) {
        facts.anyAnimated = facts.anyAnimated || batch.isAnimated();
        facts.allAnimated = facts.allAnimated && batch.isAnimated();
        facts.simplified = facts.simplified || batch.geometry->simplifiedCasters.has_value();
    }
    // Clusters with casters that a section cuts away count as alpha-tested too, but lookups and
    // points take these as they are: no surface that receives light is among them.
    for (const auto& shadow : loaded.planePairs)
        facts.alphaTested =
            facts.alphaTested || (loaded.settings.castMasked && anyAlphaTested(*shadow));
    facts.cutoutsCast = loaded.cutoutsCast;
    return facts;
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
