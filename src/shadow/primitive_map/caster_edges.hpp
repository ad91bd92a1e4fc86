#pragma once

#include "preprocess/mesh/edges.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/primitive_map/cutouts.hpp"

#include <memory>

namespace edgeshade {

/// The casting triangles of a batch with all their edges, flat ones too; of no light yet.
struct CasterEdges {
    WeldedMesh mesh; ///< as wound, in the order of PlanePairShadow::caps
    EdgeList edges;
    std::vector<CutoutTriangle> cutouts{}; ///< one a triangle, or none: all of them are solid
};

/// Of what a batch's caps are. Throws nothing but for memory.
CasterEdges casterEdgesOf(const PlanePairShadow& shadow);

/// Of a batch's MASK triangles, which cast what their alpha leaves of them.
CasterEdges cutoutEdgesOf(const Batch& batch, const std::vector<Material>& materials);

/// Casters where they are.
struct PlacedCasters {
    std::shared_ptr<const CasterEdges> casters;
    glm::dmat4 worldFromBatch{1.0};
    bool cast = true; ///< false: left out
};

} // namespace edgeshade
