#pragma once

#include "preprocess/scene/scene.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <memory>
#include <span>

namespace edgeshade {

/// The casters of a scene, and the records of them.
struct LayerCasters {
    const Scene& scene;
    /// One per batch, of the same casters in the same pose; may be null for a hidden batch.
    std::span<const std::shared_ptr<const PlanePairShadow>> records;
    bool castMasked = false; ///< as in CasterSettings
};

} // namespace edgeshade
