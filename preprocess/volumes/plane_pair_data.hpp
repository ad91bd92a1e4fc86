#pragma once

#include "preprocess/mesh/components.hpp"
#include "preprocess/volumes/plane_pair_records.hpp"

namespace edgeshade {

/// Cost of plane-pair records; += sums over batches.
struct PlanePairCosts {
    std::size_t records = 0;
    std::size_t flatEdges = 0;
    std::size_t sideBytes = 0; ///< on the GPU, instanced
    std::size_t capBytes = 0;  ///< of all caps; each cap is uploaded when first drawn
    /// Vertex shader runs for one point light, if neither it nor the eye is within any cluster's
    /// bounds and everything is in view.
    std::size_t sideRuns = 0;
    std::size_t capRuns = 0; ///< for all caps; volumes that the eye is outside of need none

    PlanePairCosts& operator+=(const PlanePairCosts& other);
    /// The cost of one more place for existing records: vertices.
    PlanePairCosts runsAlone() const;
};

/// The costs of buildPlanePairs() with the same arguments, without making the records.
/// `components`: the mesh's. `deforms`: no pair is dropped.
PlanePairCosts planePairCosts(const CasterMesh& mesh, const EdgeList& edges,
                              const Components& components, const std::vector<Material>& materials,
                              double flatTolerance, bool deforms, Threads threads = {});

/// Builds the records of one batch. `materials` decide which casters are alpha-tested;
/// `flatTolerance`: degrees, see trianglePlanes().
PlanePairShadow buildPlanePairs(const CasterMesh& mesh, const EdgeList& edges,
                                const std::vector<Material>& materials, double flatTolerance = 0.0,
                                Threads threads = {});

/// Builds the records of a batch. If it deforms, they serve all poses (weldForRecords()), with
/// RecordVertices and without patches.
PlanePairShadow buildPlanePairs(const Batch& batch, const Casters& casters,
                                const std::vector<Material>& materials, double flatTolerance);

/// The triangles of the caps, welded as weld() does.
WeldedMesh weldCaps(std::span<const CapRecord> caps);

/// The records of a deforming batch, made by buildPlanePairs(), at its current vertices. Only
/// positions, planes and boxes differ.
PlanePairShadow posedPlanePairs(const PlanePairShadow& shadow, const Batch& batch);

/// All steps for every batch of a scene: weld, edges, records.
std::vector<std::shared_ptr<const PlanePairShadow>>
buildPlanePairs(const Scene& scene, bool castMasked, double flatTolerance = 0.0);

} // namespace edgeshade
