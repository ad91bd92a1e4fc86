#include "src/scene/cut_loaded.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

bool isEmpty(const Scene& scene) {
    return std::all_of(scene.batches.begin(), scene.batches.end(), [&](const Batch& batch) {
        const auto& groups = batch.geometry->groups;
        return batch.ground || batch.hidden ||
               std::none_of(groups.begin(), groups.end(), [&](const SurfaceGroup& group) {
                   return scene.materials[group.material].isSeen();
               });
    });
}

} // namespace

void cutScene(LoadedScene& loaded, const Section& section) {
    if (!loaded.uncut) {
        if (section.planes.empty()) return;
        loaded.uncut = std::make_shared<UncutScene>(
            UncutScene{SceneCutter(std::move(loaded.scene), loaded.settings.castMasked),
                       loaded.planePairs, loaded.shadows});
    }
    UncutScene& uncut = *loaded.uncut;
    const Scene& whole = uncut.cutter.whole();
    loaded.scene = uncut.cutter.cut(section);
    loaded.planePairs = byGeometry(loaded.scene.batches, [&](std::size_t i) {
        const Batch& batch = loaded.scene.batches[i];
        if (&*batch.geometry == &*whole.batches[i].geometry) return uncut.planePairs[i];
        const Casters casters =
            castersOf(batch, loaded.scene.materials, loaded.settings.castMasked);
        return std::make_shared<const PlanePairShadow>(
            buildPlanePairs(batch, casters, loaded.scene.materials, loaded.settings.flatTolerance));
    });
    if (section.planes.empty()) {
        loaded.shadows = uncut.shadows;
        loaded.uncut.reset();
        return;
    }
    loaded.shadows.clear(); // these are for the surfaces before
    if (isEmpty(loaded.scene))
        loaded.scene.warnings.add("--section leaves nothing of the scene: it keeps the points "
                                  "where NX*x + NY*y + NZ*z + D is 0 or more.");
}

} // namespace edgeshade
