// What filling shadow volumes takes by estimate, over the flight of bench, in two suns and a lamp,
// with volumes that end by cost and otherwise, and what planning them takes. No GL is needed.
// `fill_costs SCENE...` prints JSON.
#include "src/bench/flythrough.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/geometry/light_reach.hpp"
#include "src/shadow/plan/volume_fill.hpp"
#include "tests/bench/told_scenes.hpp"
#include "tests/support/placed_shadows.hpp"

#include <ctime>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int width = 960, height = 540, frames = 8;
constexpr double aspect = static_cast<double>(width) / height;

constexpr std::pair<const char*, VolumeEnds> choices[] = {{"cost", VolumeEnds::byCost},
                                                          {"planes", VolumeEnds::atPlanes},
                                                          {"infinity", VolumeEnds::atInfinity}};

/// The mean of a flight's frames.
Json flown(const LoadedScene& loaded, const std::vector<PlacedShadow>& casters, const Light& light,
           VolumeEnds ends) {
    const Box bounds = worldBounds(loaded.scene);
    const bench::Flythrough flight(bounds, 50.0, aspect);
    PotentialSilhouettes silhouettes(23);
    PlanSettings settings;
    settings.silhouettes = &silhouettes;
    settings.ends = ends;
    FillCost fill;
    double planMs = 0.0;
    std::size_t draws = 0;
    for (int frame = 0; frame < frames; ++frame) {
        FrameRequest request;
        request.frustum = frustumOf(flight.cameraAt(static_cast<double>(frame) / frames), aspect);
        request.width = width;
        request.height = height;
        request.lights = {light};
        const FrameView view = makeFrameView(loaded.scene, request, bounds);
        for (const DepthSlice& slice : view.slices) {
            silhouettes.beginFrame(nullptr);
            const auto planned = [&] {
                return planCount(casters, loaded.scene.materials, view, slice, 0, settings);
            };
            planned(); // lists silhouettes, where none are kept
            const std::clock_t start = std::clock();
            const CountPlan plan = planned();
            planMs += 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
            draws += plan.draws.twice.size() + plan.draws.once.size();
            fill += fillOf(plan, view, slice, lightReach(view, slice, light));
        }
    }
    const FillCost mean = fill.times(1.0 / frames);
    return {{"triangles", std::llround(mean.triangles)},
            {"tile_pairs", std::llround(mean.tilePairs)},
            {"fragments", std::llround(mean.fragments)},
            {"llvmpipe_ms", 1e-6 * FillWeights().of(mean)},
            {"draws", static_cast<double>(draws) / frames},
            {"plan_ms", planMs / frames}};
}

Json measured(const std::string& path) {
    LoadedScene loaded = loadScene(path, std::nullopt);
    loaded.scene.culls = false;
    const auto casters = test::placedShadows(loaded.scene, loaded.planePairs);
    const Box bounds = worldBounds(loaded.scene);
    const glm::dvec3 at = besideAndAbove(bounds);
    const std::pair<const char*, Light> lights[] = {{"sun", {{0.4, 1, 0.3, 0}}},
                                                    {"low sun", {{-0.9, 0.25, 0.35, 0}}},
                                                    {"lamp", {glm::dvec4(at, 1.0)}}};
    Json told = {{"scene", std::filesystem::path(path).stem().string()}};
    for (const auto& [lightName, light] : lights)
        for (const auto& [choice, ends] : choices)
            told[lightName][choice] = flown(loaded, casters, light, ends);
    return told;
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
