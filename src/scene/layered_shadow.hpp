#pragma once

#include "src/scene/load.hpp"

#include <span>

namespace edgeshade {

/// Topology of a batch's casters in one group.
struct GroupTopology {
    Casters casters;
    CasterMesh mesh;
    EdgeList edges;
};

/// The topology of a batch's triangles in one group, as if it had no others: its shadow data are
/// closed by themselves. `groupOf`: the group of each of the batch's casters.
GroupTopology groupTopology(const Batch& batch, const std::vector<Material>& materials,
                            bool castMasked, std::span<const std::uint32_t> groupOf,
                            std::uint32_t group);

} // namespace edgeshade
