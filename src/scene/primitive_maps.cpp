#include "src/scene/primitive_maps.hpp"

#include "preprocess/base/stopwatch.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

bool isAllOpaque(const Scene& scene) {
    return std::all_of(scene.batches.begin(), scene.batches.end(), [&](const Batch& batch) {
        return std::all_of(batch.groups.begin(), batch.groups.end(), [&](const SurfaceGroup& g) {
            return scene.materials[g.material].alphaMode == AlphaMode::opaque;
        });
    });
}

} // namespace

std::string primitiveMapObstacle(const LoadedScene& loaded, const gl::Capabilities& capabilities) {
    if (!gl::hasFloatTables(capabilities)) return "the GL looks up no floats";
    const auto simplified = [](const Batch& batch) { return batch.simplifiedCasters.has_value(); };
    const auto& batches = loaded.scene.batches;
    if (std::any_of(batches.begin(), batches.end(), simplified)) return "casters are simplified";
    for (const auto& shadow : loaded.planePairs)
        for (const ShadowCluster& cluster : shadow->clusters)
            if (cluster.alphaTested) return "some casters are alpha-tested";
    return {};
}

const PrimitiveMapState* PrimitiveMaps::of(const Light& light) const {
    const auto found = std::find_if(kept_.begin(), kept_.end(),
                                    [&](const Kept& kept) { return kept.light == light.position; });
    return found == kept_.end() ? nullptr : &found->state;
}

std::size_t PrimitiveMaps::bytes() const {
    std::size_t total = 0;
    for (const Kept& kept : kept_)
        if (kept.state.map) total += kept.state.map->bytes();
    return total;
}

void PrimitiveMaps::make(const LoadedScene& loaded, const std::vector<bool>& hidden,
                         const std::vector<Light>& lights, const PrimitiveMapSettings& settings,
                         const gl::Capabilities& capabilities) {
    std::erase_if(kept_, [&](const Kept& kept) {
        return std::none_of(lights.begin(), lights.end(),
                            [&](const Light& light) { return light.position == kept.light; });
    });
    for (const Light& light : lights) {
        if (of(light)) continue;
        PrimitiveMapState state;
        state.why = primitiveMapObstacle(loaded, capabilities);
        if (state.why.empty()) {
            Stopwatch watch;
            PrimitiveMapSettings used = settings;
            used.othersReceive = !isAllOpaque(loaded.scene);
            std::vector<PlacedCasters> casters;
            for (std::size_t i = 0; i < loaded.scene.batches.size(); ++i) {
                if (i < hidden.size() && hidden[i]) continue;
                auto& edges = edges_[loaded.planePairs[i]];
                if (!edges)
                    edges =
                        std::make_shared<const CasterEdges>(casterEdgesOf(*loaded.planePairs[i]));
                casters.push_back({edges, loaded.scene.batches[i].worldFromBatch});
            }
            const auto map = buildPrimitiveMap(light, casters, used);
            std::vector<std::vector<SortedTriangles>> triangles;
            for (const Batch& batch : loaded.scene.batches)
                triangles.push_back(
                    sortedByFacing(batch, glm::inverse(batch.worldFromBatch) * light.position));
            state.buildMs = 1e3 * watch.lap();
            if (map) {
                state.map = std::make_shared<const GpuPrimitiveMap>(
                    uploadPrimitiveMap(*map, triangles, capabilities));
                state.why = "at rest";
            } else {
                state.why = "a map would take more than " +
                            std::to_string(settings.mostBytes >> 20) + " MB";
            }
        }
        kept_.push_back({light.position, std::move(state)});
    }
}

} // namespace edgeshade
