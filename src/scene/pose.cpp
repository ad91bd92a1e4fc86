#include "src/scene/pose.hpp"

#include "preprocess/reading/animation_reading.hpp"

namespace edgeshade {
namespace {

void removeTriangles(LoadedScene& loaded, std::size_t batch) {
    Batch& of = loaded.scene.batches[batch];
    Batch empty;
    empty.node = of.node;
    empty.worldFromBatch = of.worldFromBatch;
    empty.nodeFromBatch = of.nodeFromBatch;
    of = empty;
    loaded.planePairs[batch] = std::make_shared<const PlanePairShadow>();
    if (!loaded.shadows.empty()) loaded.shadows[batch] = std::make_shared<const BatchShadow>();
}

} // namespace

std::vector<Placed> placeScene(LoadedScene& loaded, const Pose& pose) {
    std::vector<Placed> placed = place(loaded.scene, pose);
    for (std::size_t b = 0; b < placed.size(); ++b) {
        if (!placed[b].reshaped) continue;
        loaded.planePairs[b] = std::make_shared<const PlanePairShadow>(
            posedPlanePairs(*loaded.planePairs[b], loaded.scene.batches[b]));
        loaded.shadows.clear(); // these are for the previous shape
    }
    return placed;
}

std::optional<std::vector<Placed>> placeAt(LoadedScene& loaded, double seconds,
                                           const std::string& animation) {
    if (!loaded.document) return std::nullopt;
    const std::vector<AnimationTitle> titles = animationTitles(*loaded.document);
    std::optional<std::size_t> index;
    if (!animation.empty()) {
        const AnimationTitle* const found = findAnimation(titles, animation);
        if (!found) {
            std::string all;
            for (const AnimationTitle& title : titles)
                all += (all.empty() ? "it has " : ", ") + std::to_string(title.index) + " '" +
                       title.name + "'";
            loaded.scene.warnings.add("--animation: the file has no animation '" + animation +
                                      "'; " + (all.empty() ? "it has none" : all) +
                                      ". The scene is at rest.");
            return std::nullopt;
        }
        index = found->index;
    } else if (titles.size() > 1) {
        loaded.scene.warnings.add("The file has " + std::to_string(titles.size()) +
                                  " animations; the first, '" + titles.front().name +
                                  "', is shown, and --animation chooses another.");
    }
    const auto read = readAnimation(*loaded.document, loaded.scene.warnings, index);
    if (!read) return std::nullopt;
    return placeScene(loaded, poseAt(*read, loaded.scene, seconds));
}

void leaveOutHidden(LoadedScene& loaded) {
    for (std::size_t b = 0; b < loaded.scene.batches.size(); ++b)
        if (loaded.scene.batches[b].hidden) removeTriangles(loaded, b);
}

bool poseScene(LoadedScene& loaded, double seconds, const std::string& animation) {
    const auto placed = placeAt(loaded, seconds, animation);
    if (!placed) return false;
    loaded.time = seconds;
    loaded.animation = animation;
    leaveOutHidden(loaded);
    return true;
}

void holdStill(Scene& scene) {
    for (Batch& batch : scene.batches)
        batch.node = -1;
}

} // namespace edgeshade
