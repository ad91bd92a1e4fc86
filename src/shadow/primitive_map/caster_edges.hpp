#pragma once

#include "preprocess/mesh/edges.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <memory>

namespace edgeshade {

/// The casting triangles of a batch with all their edges, flat ones too; of no light yet.
struct CasterEdges {
    WeldedMesh mesh; ///< as wound, in the order of PlanePairShadow::caps
    EdgeList edges;
};

/// Of what a batch's caps are. Throws nothing but for memory.
CasterEdges casterEdgesOf(const PlanePairShadow& shadow);

/// Casters where they are.
struct PlacedCasters {
    std::shared_ptr<const CasterEdges> casters;
    glm::dmat4 worldFromBatch{1.0};
    bool cast = true; ///< false: left out
};

} // namespace edgeshade
