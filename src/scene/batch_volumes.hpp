#pragma once

#include "src/scene/plane_pair_buffers.hpp"
#include "src/scene/shadow_buffers.hpp"

#include <compare>
#include <memory>

namespace edgeshade {

/// The records from which shadow volumes are drawn.
enum class VolumeLayout {
    planePairs, ///< records of what the scene requires: preprocess/volumes/plane_pair_data.hpp
    oppositeVertices, ///< one global multiplicity, every edge, opposite vertices: the published
                      ///< baseline
    triangles,        ///< casting triangles, each with its own volume: brute force
};

/// Which records are on the GPU, and how they reach the vertex shader.
struct VolumeRecords {
    VolumeLayout volumes = VolumeLayout::planePairs;
    SidesLayout layout = SidesLayout::instanced;

    auto operator<=>(const VolumeRecords&) const = default;
};

/// One batch's shadow data on the GPU, in one or more layouts; null where absent. Batches with the
/// same geometry share them.
struct BatchVolumes {
    std::shared_ptr<PlanePairBuffers> planePairs;
    std::shared_ptr<ShadowBuffers> oppositeVertices;
    std::shared_ptr<ShadowBuffers> triangles; ///< as caps

    std::size_t sideBytes() const {
        return (planePairs ? planePairs->sideBytes() : 0) +
               (oppositeVertices ? oppositeVertices->sideBytes() : 0);
    }
    std::size_t capBytes() const {
        return (planePairs ? planePairs->capBytes() : 0) +
               (oppositeVertices ? oppositeVertices->capBytes() : 0) +
               (triangles ? triangles->capBytes() : 0);
    }
    std::size_t bytes() const { return sideBytes() + capBytes(); }
};

} // namespace edgeshade
