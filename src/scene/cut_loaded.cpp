#include "src/scene/cut_loaded.hpp"

#include "preprocess/section/component_blocks.hpp"

#include <algorithm>
#include <map>

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
        loaded.scene = std::move(loaded.uncut->scene);
        loaded.planePairs = std::move(loaded.uncut->planePairs);
        loaded.shadows = std::move(loaded.uncut->shadows);
        loaded.uncut.reset();
        return;
    }
    if (!loaded.uncut) {
        Scene blocks = inBlocks(loaded.scene);
        auto ofBlocks =
            buildPlanePairs(blocks, loaded.settings.castMasked, loaded.settings.flatTolerance);
        loaded.uncut = std::make_shared<UncutScene>(UncutScene{
            std::move(loaded.scene), std::move(loaded.planePairs), std::move(loaded.shadows),
            SceneCutter(std::move(blocks), loaded.settings.castMasked), std::move(ofBlocks)});
    }
    UncutScene& uncut = *loaded.uncut;
    const Scene& whole = uncut.cutter.whole();
    loaded.scene = uncut.cutter.cut(section);
    loaded.shadows.clear();
    std::map<const Geometry*, std::shared_ptr<const PlanePairShadow>> known;
    for (const auto& [geometry, records] : uncut.last)
        known.emplace(&*geometry, records);
    loaded.planePairs = byGeometry(loaded.scene.batches, [&](std::size_t i) {
        const Batch& batch = loaded.scene.batches[i];
        if (&*batch.geometry == &*whole.batches[i].geometry) return uncut.ofBlocks[i];
        if (const auto found = known.find(&*batch.geometry); found != known.end())
            return found->second;
        const Casters casters =
            castersOf(batch, loaded.scene.materials, loaded.settings.castMasked);
        return std::make_shared<const PlanePairShadow>(
            buildPlanePairs(batch, casters, loaded.scene.materials, loaded.settings.flatTolerance));
    });
    uncut.last.clear();
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        uncut.last.emplace_back(loaded.scene.batches[i].geometry, loaded.planePairs[i]);
    if (isEmpty(loaded.scene))
        loaded.scene.warnings.add("--section leaves nothing of the scene: it keeps the points "
                                  "where NX*x + NY*y + NZ*z + D is 0 or more.");
}

} // namespace edgeshade
