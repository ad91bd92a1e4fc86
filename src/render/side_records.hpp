#pragma once

#include "src/render/proposals.hpp"
#include "src/render/volume_plan.hpp"

#include <vector>

namespace edgeshade {

/// How often sides count: as the absolute value of their multiplicity says.
enum class Times { once = 1, twice = 2 };

/// Neighbouring records that a draw takes to the vertex shader.
struct SideRecords {
    enum class Kind { singles, allPairs, certainPairs, uncertainPairs };
    Kind kind;
    RecordRange range;

    bool isPair() const { return kind != Kind::singles; }
};

/// Those among which the draw's sides are that count so often. A single record counts once. So does
/// a pair where one triangle of a silhouette edge casts. Where both cast it counts twice, but once
/// where the light is in the plane of either.
std::vector<SideRecords> sideRecords(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                                     const VolumeDraw& draw, Times times);

/// Whether a cluster's caps are drawn from its silhouette edges, each joined to the cluster's
/// middle: where the plan allows it (VolumeDraw::fannedCaps) and fewer vertices are needed for
/// them.
bool takesFannedCaps(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                     const VolumeDraw& draw, std::uint32_t cluster);

/// The same draw of one of its clusters.
VolumeDraw drawOf(const VolumeDraw& draw, std::uint32_t cluster);

/// Whether some of the draws' sides may count twice; `proposed` as in drawSides().
bool mayCountTwice(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                   const std::vector<VolumeDraw>& draws);

/// How many vertices the vertex shader runs for such draws; `proposed` as in drawSides().
std::size_t vertexRuns(const AdaptedShadow& shadow, const ProposedRecords* proposed,
                       const std::vector<VolumeDraw>& draws, const std::vector<Material>& materials,
                       bool sun);

} // namespace edgeshade
