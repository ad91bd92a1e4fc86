#pragma once

#include "preprocess/mesh/edges.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/primitive_map/cutouts.hpp"

#include <memory>

namespace edgeshade {

/// The casting triangles of a batch with all their edges, flat ones too; independent of the light.
struct CasterEdges {
    WeldedMesh mesh; ///< in their own winding, in the order of PlanePairShadow::caps
    EdgeList edges;
    std::vector<CutoutTriangle> cutouts{}; ///< one per triangle; empty: all are solid
};

/// The edges of a batch's caps. Throws only if out of memory.
CasterEdges casterEdgesOf(const PlanePairShadow& shadow);

/// The edges of a batch's MASK triangles, which cast where their alpha leaves them.
CasterEdges cutoutEdgesOf(const Batch& batch, const std::vector<Material>& materials);

/// Casters at their place in the world.
struct PlacedCasters {
    std::shared_ptr<const CasterEdges> casters;
    glm::dmat4 worldFromBatch{1.0};
    bool cast = true; ///< false: ignored
};

} // namespace edgeshade
