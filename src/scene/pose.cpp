#include "src/scene/pose.hpp"

#include "preprocess/reading/animation_reading.hpp"

namespace edgeshade {
namespace {

void removeTriangles(LoadedScene& loaded, std::size_t batch) {
    Batch& of = loaded.scene.batches[batch];
    Batch empty;
    empty.node = of.node;
    empty.worldFromBatch = of.worldFromBatch;
    empty.origin = of.origin;
    of = empty;
    loaded.planePairs[batch] = std::make_shared<const PlanePairShadow>();
    if (!loaded.shadows.empty()) loaded.shadows[batch] = {};
}

} // namespace

std::optional<Pose> placeAt(LoadedScene& loaded, double seconds) {
    if (!loaded.document) return std::nullopt;
    const auto animation = readAnimation(*loaded.document, loaded.scene.warnings);
    if (!animation) return std::nullopt;
    Pose pose = poseAt(*animation, loaded.scene, seconds);
    place(loaded.scene, pose);
    return pose;
}

bool poseScene(LoadedScene& loaded, double seconds) {
    const auto pose = placeAt(loaded, seconds);
    if (!pose) return false;
    loaded.time = seconds;
    for (std::size_t b = 0; b < pose->worldFromBatch.size(); ++b)
        if (!pose->worldFromBatch[b]) removeTriangles(loaded, b);
    return true;
}

} // namespace edgeshade
