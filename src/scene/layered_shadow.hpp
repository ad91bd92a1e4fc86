#pragma once

#include "src/scene/load.hpp"

#include <span>

namespace edgeshade {

/// Topology of a batch's casters that are in one group.
struct GroupTopology {
    Casters casters;
    CasterMesh mesh;
    EdgeList edges;
};

/// What is left of a batch's topology when all triangles but one group's are taken away: its shadow
/// data are closed by themselves. `groupOf`: the group of each of its casters.
GroupTopology groupTopology(const Batch& batch, const std::vector<Material>& materials,
                            bool castMasked, std::span<const std::uint32_t> groupOf,
                            std::uint32_t group);

} // namespace edgeshade
