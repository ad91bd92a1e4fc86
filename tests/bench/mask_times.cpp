// Processor time of ShadowMasks::draw() for a scene of many meshes, one for each node of a glTF
// file, under a light that moves, and under three at rest. `mask_times SCENE...` prints JSON. With
// null_gl in front of the GL it is the processor's share.
#include "edgeshade/shadow_masks.hpp"
#include "src/bench/flythrough.hpp"
#include "src/bench/statistics.hpp"
#include "src/gl/headless_context.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/view/frustum.hpp"
#include "tests/bench/egl_host.hpp"
#include "tests/bench/told_scenes.hpp"

#include <glm/gtc/type_ptr.hpp>
#include <map>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frames = 400, width = 1280, height = 720;

/// Adds a batch as its nodes' meshes. Returns their number.
std::size_t addMeshes(ShadowMasks& masks, const Batch& batch) {
    const Geometry& geometry = *batch.geometry;
    const std::span<const float> positions(&geometry.positions.data()->x,
                                           3 * geometry.positions.size());
    std::size_t added = 0, first = 0;
    const auto add = [&](std::size_t end) {
        if (end == first) return;
        // Only this mesh's vertices.
        std::vector<float> own;
        std::vector<std::uint32_t> indices;
        std::map<std::uint32_t, std::uint32_t> number;
        for (std::size_t i = first; i < end; ++i) {
            const std::uint32_t vertex = geometry.indices[i];
            const auto [at, isNew] =
                number.emplace(vertex, static_cast<std::uint32_t>(own.size() / 3));
            if (isNew) own.insert(own.end(), &positions[3 * vertex], &positions[3 * vertex] + 3);
            indices.push_back(at->second);
        }
        masks.add(MaskMesh{.positions = own, .indices = indices}, numbersOf(batch.worldFromBatch));
        first = end;
        ++added;
    };
    for (std::size_t i = 1; i < geometry.sources.size(); ++i)
        add(geometry.sources[i].firstIndex);
    add(geometry.indices.size());
    return added;
}

Json measured(const std::string& path) {
    const gl::HeadlessContext context({width, height});
    const LoadedScene loaded = loadScene(path, std::nullopt);
    const Box bounds = worldBounds(loaded.scene);
    ShadowMasks masks(eglAddressOf);
    std::size_t meshes = 0;
    for (const Batch& batch : loaded.scene.batches)
        meshes += addMeshes(masks, batch);
    const double aspect = static_cast<double>(width) / height;
    const bench::Flythrough flight(bounds, 50.0, aspect);
    const auto drawn = [&](int frame, std::span<const MaskLight> lights) {
        const Frustum frustum =
            frustumOf(flight.cameraAt(static_cast<double>(frame) / frames), aspect);
        const MaskView view{.viewFromWorld = numbersOf(frustum.viewFromWorld),
                            .clipFromView = numbersOf(clipFromView(frustum, 0.1, 1e4)),
                            .width = width,
                            .height = height};
        masks.draw(view, lights);
        return masks.cost().drawMs;
    };
    std::vector<double> ms, atRest;
    for (int frame = 0; frame < frames; ++frame) {
        MaskLight light;
        light.direction = {-0.4 + 0.002 * frame, -1.0, -0.3};
        ms.push_back(drawn(frame, {&light, 1}));
    }
    std::array<MaskLight, 3> resting;
    for (std::size_t i = 0; i < resting.size(); ++i)
        resting[i].direction = {-0.4 + 0.3 * static_cast<double>(i), -1.0, -0.3};
    for (int frame = 0; frame < frames / 4; ++frame)
        atRest.push_back(drawn(frame, resting));
    return {{"scene", std::filesystem::path(path).stem().string()},
            {"meshes", meshes},
            {"batches", masks.cost().batches},
            {"first_ms", ms.front()},
            {"single_ms", bench::median({ms.begin() + 4, ms.begin() + 28})},
            {"merging_ms", *std::max_element(ms.begin() + 28, ms.end())},
            {"merged_ms", bench::median({ms.end() - 50, ms.end()})},
            {"three_at_rest_ms", bench::median({atRest.begin() + 10, atRest.end()})},
            {"three_at_rest_vertex_runs", masks.cost().vertexRuns}};
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
