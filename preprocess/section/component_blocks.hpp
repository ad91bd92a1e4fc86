#pragma once

#include "preprocess/mesh/components.hpp"
#include "preprocess/scene/scene.hpp"

#include <map>

namespace edgeshade {

/// KnownTopologies of all triangles of some geometries.
using KnownTopologies = std::map<const Geometry*, MeshTopology>;

/// A scene in blocks.
struct SceneInBlocks {
    Scene scene;
    KnownTopologies topologies; ///< of batches that stay whole, where they were found
};

/// The scene with its large batches divided into blocks of whole components near each other, each a
/// batch of its own. A plane that is dragged changes only the blocks that it crosses. Batches that
/// deform, that share their geometry, or that have simplified casters stay whole.
SceneInBlocks inBlocks(const Scene& scene);

} // namespace edgeshade
