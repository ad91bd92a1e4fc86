#pragma once

#include "preprocess/base/shared_pool.hpp"
#include "preprocess/section/cut_scene.hpp"
#include "preprocess/volumes/cut_records.hpp"
#include "src/scene/load.hpp"

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace edgeshade {

/// A geometry whose records follow its cuts.
struct FollowedGeometry {
    UncutRecords uncut;
    SharedPool<PlanePairShadow> made = {}; ///< records of its cuts
};

/// A loaded scene as it was before a section cut it.
struct UncutScene {
    Scene scene;
    std::vector<std::shared_ptr<const PlanePairShadow>> planePairs;
    Shadows shadows;
    SceneCutter cutter; ///< of the scene in blocks, inBlocks()
    /// Records of the cutter's geometries, made when a cut first leaves one whole.
    std::map<const Geometry*, std::shared_ptr<const PlanePairShadow>> ofWhole = {};
    /// Geometries of the cutter, made when a cut first crosses them; null for those that
    /// cutRecords() doesn't apply to.
    std::map<const Geometry*, std::unique_ptr<FollowedGeometry>> followed = {};
    CutMemory memory = {};
    /// Geometries of the last cut and their records, for those that the next one leaves.
    std::vector<std::pair<CopyOnWrite<Geometry>, std::shared_ptr<const PlanePairShadow>>> last = {};
};

/// Cuts a scene by a section, in place of the one that it may have; a section without planes makes
/// it whole again. While it is cut it has more batches, so that records are built only for those
/// that a plane crosses or crossed, and shared by the others. Warns if nothing of the scene is
/// left.
void cutScene(LoadedScene& loaded, const Section& section);

} // namespace edgeshade
