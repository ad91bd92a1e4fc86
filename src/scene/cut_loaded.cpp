#include "src/scene/cut_loaded.hpp"

#include "preprocess/section/component_blocks.hpp"

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
    if (section.planes.empty()) {
        if (!loaded.uncut) return;
        // Copied, because copies of the loaded scene share it.
        loaded.scene = loaded.uncut->scene;
        loaded.planePairs = loaded.uncut->planePairs;
        loaded.shadows = loaded.uncut->shadows;
        loaded.uncut.reset();
        return;
    }
    if (!loaded.uncut) {
        SceneCutter cutter(inBlocks(loaded.scene), loaded.settings.castMasked);
        loaded.uncut = std::make_shared<UncutScene>(
            UncutScene{std::move(loaded.scene), std::move(loaded.planePairs),
                       std::move(loaded.shadows), std::move(cutter)});
        UncutScene& made = *loaded.uncut;
        for (std::size_t i = 0; i < made.planePairs.size(); ++i) // for those that are no blocks
            made.ofWhole.emplace(&*made.scene.batches[i].geometry, made.planePairs[i]);
    }
    UncutScene& uncut = *loaded.uncut;
    const Scene& whole = uncut.cutter.whole();
    loaded.scene = uncut.cutter.cut(section);
    loaded.shadows.clear();
    std::map<const Geometry*, std::shared_ptr<const PlanePairShadow>> known = uncut.ofWhole;
    for (const auto& [geometry, records] : uncut.last)
        known.emplace(&*geometry, records);
    loaded.planePairs = byGeometry(loaded.scene.batches, [&](std::size_t i) {
        const Batch& batch = loaded.scene.batches[i];
        const Geometry* const geometry = &*batch.geometry;
        if (const auto found = known.find(geometry); found != known.end()) return found->second;
        const Casters casters =
            castersOf(batch, loaded.scene.materials, loaded.settings.castMasked);
        auto records = std::make_shared<const PlanePairShadow>(
            buildPlanePairs(batch, casters, loaded.scene.materials, loaded.settings.flatTolerance));
        if (geometry == &*whole.batches[i].geometry) uncut.ofWhole.emplace(geometry, records);
        return records;
    });
    uncut.last.clear();
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        uncut.last.emplace_back(loaded.scene.batches[i].geometry, loaded.planePairs[i]);
    if (isEmpty(loaded.scene))
        loaded.scene.warnings.add("--section leaves nothing of the scene: it keeps the points "
                                  "where NX*x + NY*y + NZ*z + D is 0 or more.");
}

} // namespace edgeshade
