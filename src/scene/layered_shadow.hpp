#pragma once

#include "src/scene/load.hpp"
#include "src/scene/shadow_buffers.hpp"

namespace edgeshade {

/// Shadow data of one group of casting triangles, batch by batch: what is left of sides and caps
/// when all other triangles are taken away, closed by itself.
struct CasterGroupShadow {
    std::vector<BatchShadow> shadows;          ///< one a batch
    std::vector<std::vector<glm::vec4>> holes; ///< capHoles() of each
};

/// Builds the group's shadow data. `groupOf`: the group of each casting triangle, in the order of
/// batches and their casters.
CasterGroupShadow groupShadow(const Scene& scene, bool castMasked,
                              std::span<const std::uint32_t> groupOf, std::uint32_t group);

} // namespace edgeshade
