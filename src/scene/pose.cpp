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

bool poseScene(LoadedScene& loaded, double seconds) {
    if (!loaded.document) return false;
    const auto animation = readAnimation(*loaded.document, loaded.scene.warnings);
    if (!animation) return false;
    loaded.time = seconds;
    const Pose pose = poseAt(*animation, loaded.scene, seconds);
    place(loaded.scene, pose);
    for (std::size_t b = 0; b < pose.worldFromBatch.size(); ++b)
        if (!pose.worldFromBatch[b]) removeTriangles(loaded, b);
    return true;
}

} // namespace edgeshade
