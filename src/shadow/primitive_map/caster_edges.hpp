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
    /// The triangles are tinted and close a solid, which a ray counts once: where it enters, or
    /// where it leaves a solid that the light is in.
    bool tintedSolid = false;
};

/// The edges of a batch's caps. Throws only if out of memory.
CasterEdges casterEdgesOf(const PlanePairShadow& shadow);

/// The edges of a batch's MASK triangles, which cast where their alpha leaves them.
CasterEdges cutoutEdgesOf(const Batch& batch, const std::vector<Material>& materials);

/// The edges of all triangles of a batch, tinted by the material of this number.
CasterEdges tintedEdgesOf(const Batch& batch, std::uint32_t material);

/// Casters at their place in the world.
struct PlacedCasters {
    std::shared_ptr<const CasterEdges> casters;
    glm::dmat4 worldFromBatch{1.0};
    bool cast = true; ///< false: ignored
};

} // namespace edgeshade
