#pragma once

#include "src/engine/mesh_merging.hpp"

namespace edgeshade {

struct MergedMeshes::Data {
    std::vector<std::size_t> numbers; ///< the members' indices in the host's list
    std::vector<PlacedMesh> members;
    MergedMesh merged;
};

} // namespace edgeshade
