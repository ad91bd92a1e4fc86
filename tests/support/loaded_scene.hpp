#pragma once

#include "src/scene/load.hpp"

namespace edgeshade::test {

/// The scene with its shadow data, as if loaded from a file.
inline LoadedScene loadedOf(const Scene& scene) {
    LoadedScene loaded;
    loaded.scene = scene;
    loaded.planePairs = buildPlanePairs(scene, false);
    return loaded;
}

} // namespace edgeshade::test
