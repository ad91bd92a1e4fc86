#pragma once

#include "preprocess/scene/scene.hpp"

namespace edgeshade {

/// The scene with its large batches divided into blocks of whole components near each other, each a
/// batch of its own. A plane that is dragged changes only the blocks that it crosses. Batches that
/// deform, that share their geometry, or that have simplified casters stay whole.
Scene inBlocks(const Scene& scene);

} // namespace edgeshade
