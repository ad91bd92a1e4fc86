// Casters wholly in the shadow of others (docs/method.md, C43), of a light at one place and of one
// that may be anywhere around it: how many they are, and how long it takes to find them. No GL is
// needed. `culling_times SCENE...` prints JSON.
#include "src/scene/culling_job.hpp"
#include "src/shadow/geometry/light_region.hpp"
#include "tests/bench/told_scenes.hpp"

#include <filesystem>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// Degrees around a sun; of a lamp, 150ths of the scene's diagonal, as bench --light-circle.
constexpr double reaches[] = {0.0, 0.03, 0.1, 0.3};

Light reaching(const Light& light, double reach, const Box& bounds) {
    if (reach == 0.0) return light;
    return anywhereWithin(light, light.position.w == 0.0 ? glm::radians(reach)
                                                         : reach / 150.0 * bounds.diagonal());
}

Json measured(const std::string& path) {
    const LoadedScene loaded = loadScene(path, std::nullopt);
    const Box bounds = worldBounds(loaded.scene);
    const std::pair<const char*, Light> lights[] = {
        {"sun", {{0.4, 1, 0.3, 0}}},
        {"low sun", {{-0.9, 0.25, 0.35, 0}}},
        {"lamp", {glm::dvec4(besideAndAbove(bounds), 1.0)}}};
    Json told = {{"scene", std::filesystem::path(path).stem().string()}};
    KeptEdges edges;
    for (const auto& [name, light] : lights)
        for (const double reach : reaches) {
            CullingJob job(loaded, reaching(light, reach, bounds), 23, edges);
            job.finish();
            edges = job.edges();
            const KeptCasters& kept = job.kept();
            told["casters"] = kept.casters;
            told["lights"][name].push_back(
                {{"reach", reach}, {"gone", kept.gone}, {"ms", kept.milliseconds}});
        }
    return told;
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
