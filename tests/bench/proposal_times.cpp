// Time to propose silhouettes on one thread, and the number of records that remain, for a resting
// light and for balls around it. `proposal_times SCENE...` prints JSON.
#include "src/scene/load.hpp"
#include "src/shadow/lights/light.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"
#include "tests/bench/told_scenes.hpp"

#include <algorithm>
#include <ctime>
#include <limits>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int repeats = 20;
constexpr int runsARepeat = 10;                             // the clock has a resolution of a
                                                            // microsecond
constexpr double radii[] = {0.0, 0.001, 0.003, 0.01, 0.03}; // shares of the scene's diagonal

/// The result for one light and all batches.
struct Found {
    double milliseconds = 0.0;
    std::size_t pairs = 0;
};

Found find(const LoadedScene& loaded, const Light& light, double radius) {
    Found found;
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i) {
        const PlanePairShadow& shadow = *loaded.planePairs[i];
        const LightFacings facings(shadow);
        const LightBall ball{lightInObject(light, loaded.scene.batches[i].worldFromBatch),
                             static_cast<float>(radius)};
        SilhouetteList proposal;
        std::vector<PairRecord> gathered;
        std::clock_t least = std::numeric_limits<std::clock_t>::max();
        for (int repeat = 0; repeat < repeats; ++repeat) {
            const std::clock_t start = std::clock();
            for (int run = 0; run < runsARepeat; ++run) {
                ListMemory memory;
                listSilhouettes(shadow, facings, ball, 23, proposal,
                                std::numeric_limits<double>::infinity(), memory);
                for (const PairList* list : {&proposal.certain, &proposal.uncertain})
                    gatherPairs(shadow, *list, gathered);
            }
            least = std::min(least, std::clock() - start);
        }
        found.milliseconds += 1e3 * static_cast<double>(least) / CLOCKS_PER_SEC / runsARepeat;
        found.pairs += proposal.size();
    }
    return found;
}

Json measured(const std::string& path) {
    const LoadedScene loaded = loadScene(path, std::nullopt);
    const Box bounds = worldBounds(loaded.scene);
    const glm::dvec3 at = besideAndAbove(bounds);
    std::size_t pairs = 0, triangles = 0;
    for (const auto& shadow : loaded.planePairs) {
        pairs += shadow->pairs.size();
        triangles += shadow->caps.size();
    }
    Json balls = Json::array();
    for (const double share : radii) {
        const Found found = find(loaded, {glm::dvec4(at, 1.0)}, share * bounds.diagonal());
        balls.push_back({{"radius", share}, {"ms", found.milliseconds}, {"pairs", found.pairs}});
    }
    return {{"scene", std::filesystem::path(path).stem().string()},
            {"triangles", triangles},
            {"pairs", pairs},
            {"balls", balls}};
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
