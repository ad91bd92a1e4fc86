#pragma once

#include "preprocess/base/kept_vector.hpp"
#include "src/shadow/plan/draw_list.hpp"
#include "src/shadow/plan/solid_clusters.hpp"
#include "src/shadow/plan/stencil_start.hpp"
#include "src/shadow/silhouette/potential_silhouettes.hpp"

#include <memory>
#include <vector>

namespace edgeshade {

/// A batch's shadow data and placement, the input of a plan.
struct PlacedShadow {
    std::size_t batch = 0; ///< index in the scene
    std::shared_ptr<const PlanePairShadow> shadow;
    glm::dmat4 worldFromBatch{1.0};
};

/// The volumes counted in one stencil: those of a group of a light's casters in a depth slice.
struct CountPlan {
    KeptVector<BatchPlan> batches;
    /// Nothing is drawn; each visible point is tested by itself (docs/method.md, C46).
    bool byPoints = false;
    bool fullyShadowed = false; ///< everything visible is in shadow, so nothing is drawn
    StencilStart start;
    DrawList draws; ///< if some draws count twice, they come first, and counts are doubled after
                    ///< them

    std::size_t vertexRuns() const;

    /// Empties it, and keeps its memory.
    void clear();
};

/// Arrays that planning uses again for the next light and the next frame.
struct PlanMemory {
    ClusterMemory clusters;
    ContactCaps contact;
    FrameView seen;             ///< the part of the view that a light can change
    std::vector<double> ranges; ///< of the light, by batch; see rangeInObject()
    std::vector<std::uint8_t> fanned;
    std::vector<glm::dvec4> between, betweenInBatch; ///< PlanView::between
};

/// Settings for planning plane-pair records.
struct PlanSettings {
    int mantissaBits = 23;                       ///< precision of the vertex shader's floats
    PotentialSilhouettes* silhouettes = nullptr; ///< null: all records are drawn
    KeptSolids* solids = nullptr; ///< for scenes that cull; null: no cluster is known to be solid
    PlanMemory* memory = nullptr; ///< null: each plan takes memory of its own
};

/// Plans the draws for a group of casters and the light with index `light` in the view, into
/// `plan`, whose memory it reuses. `materials`: the scene's. Pure, except for the silhouettes that
/// are kept from frame to frame.
void planCount(const std::vector<PlacedShadow>& casters, const std::vector<Material>& materials,
               const FrameView& view, const DepthSlice& slice, std::size_t light,
               const PlanSettings& settings, CountPlan& plan);

} // namespace edgeshade
