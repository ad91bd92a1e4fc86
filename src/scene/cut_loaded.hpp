#pragma once

#include "preprocess/section/cut_scene.hpp"
#include "src/scene/load.hpp"

namespace edgeshade {

/// A loaded scene as it was before a section cut it.
struct UncutScene {
    SceneCutter cutter;
    std::vector<std::shared_ptr<const PlanePairShadow>> planePairs;
    Shadows shadows;
};

/// Cuts a scene by a section, in place of the one that it may have; a section without planes makes
/// it whole again. Records are built for the batches that change, and shared by the others. Warns
/// if nothing of the scene is left.
void cutScene(LoadedScene& loaded, const Section& section);

} // namespace edgeshade
