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

/// Input of cutRecords() for the uncut batch; null if it doesn't apply.
FollowedGeometry* followedOf(UncutScene& uncut, const Batch& batch,
                             const CasterSettings& settings) {
    const Geometry& geometry = *batch.geometry;
    const auto [found, isNew] = uncut.followed.try_emplace(&geometry);
    if (!isNew) return found->second.get();
    std::optional<MeshTopology> topology = uncut.cutter.takeTopology(geometry);
    if (batch.deforms() || geometry.simplifiedCasters || settings.flatTolerance != 0.0)
        return nullptr;
    const auto whole = uncut.ofWhole.find(&geometry);
    UncutRecords records =
        uncutRecords(batch, uncut.cutter.whole().materials, settings.castMasked,
                     whole != uncut.ofWhole.end() ? whole->second : nullptr, std::move(topology));
    uncut.ofWhole.emplace(&geometry, records.shadow);
    if (records.canFollowCuts())
        found->second = std::make_unique<FollowedGeometry>(FollowedGeometry{std::move(records)});
    return found->second.get();
}

/// The records of a batch of the cut scene.
std::shared_ptr<const PlanePairShadow> recordsOf(UncutScene& uncut, const LoadedScene& loaded,
                                                 std::size_t i) {
    const CasterSettings& settings = loaded.settings;
    const std::vector<Material>& materials = loaded.scene.materials;
    const Batch &batch = loaded.scene.batches[i], &whole = uncut.cutter.whole().batches[i];
    if (batch.origins)
        if (FollowedGeometry* const followed = followedOf(uncut, whole, settings))
            return followed->made.share(cutRecords(followed->uncut, *batch.geometry, *batch.origins,
                                                   materials, settings.castMasked, uncut.memory,
                                                   followed->made.take()));
    const Casters casters = castersOf(batch, materials, settings.castMasked);
    auto records = std::make_shared<const PlanePairShadow>(
        buildPlanePairs(batch, casters, materials, settings.flatTolerance));
    if (&*batch.geometry == &*whole.geometry) uncut.ofWhole.emplace(&*batch.geometry, records);
    return records;
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
        SceneInBlocks blocks = inBlocks(loaded.scene);
        SceneCutter cutter(std::move(blocks.scene), loaded.settings.castMasked,
                           std::move(blocks.topologies));
        loaded.uncut = std::make_shared<UncutScene>(
            UncutScene{std::move(loaded.scene), std::move(loaded.planePairs),
                       std::move(loaded.shadows), std::move(cutter)});
        UncutScene& made = *loaded.uncut;
        for (std::size_t i = 0; i < made.planePairs.size(); ++i) // for those that are no blocks
            made.ofWhole.emplace(&*made.scene.batches[i].geometry, made.planePairs[i]);
    }
    UncutScene& uncut = *loaded.uncut;
    loaded.scene = uncut.cutter.cut(section);
    loaded.shadows.clear();
    std::map<const Geometry*, std::shared_ptr<const PlanePairShadow>> known = uncut.ofWhole;
    for (const auto& [geometry, records] : uncut.last)
        known.emplace(&*geometry, records);
    loaded.planePairs = byGeometry(loaded.scene.batches, [&](std::size_t i) {
        const auto found = known.find(&*loaded.scene.batches[i].geometry);
        return found != known.end() ? found->second : recordsOf(uncut, loaded, i);
    });
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        if (!loaded.scene.batches[i].origins)
            if (const auto found = uncut.followed.find(&*uncut.cutter.whole().batches[i].geometry);
                found != uncut.followed.end() && found->second)
                found->second->made.clear();
    uncut.last.clear();
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        uncut.last.emplace_back(loaded.scene.batches[i].geometry, loaded.planePairs[i]);
    if (isEmpty(loaded.scene))
        loaded.scene.warnings.add("--section leaves nothing of the scene: it keeps the points "
                                  "where NX*x + NY*y + NZ*z + D is 0 or more.");
}

} // namespace edgeshade
