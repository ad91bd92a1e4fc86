#pragma once

#include "preprocess/mesh/components.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// The records of a geometry that sections cut, and its topology, so that the records of a cut
/// needn't find it again (docs/method/sections.md, C51).
struct UncutRecords {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// Pairs and singles of one edge, as indices, ascending.
    struct OfEdge {
        std::vector<std::uint32_t> pairs, singles;
    };

    std::shared_ptr<const PlanePairShadow> shadow;
    std::vector<std::uint32_t> capOf;       ///< by triangle of the geometry; none: it doesn't cast
    std::vector<Triangle> vertices;         ///< by cap, of the geometry
    std::vector<std::uint32_t> componentOf; ///< by cap
    std::vector<std::uint8_t> closed;       ///< by component
    /// For each cap the edges from a to b, from b to c and from c to a.
    std::vector<std::array<std::uint32_t, 3>> edgesOf;
    std::vector<RecordRange> capsOfEdge;     ///< for each edge its caps, in `edgeCaps`
    std::vector<std::uint32_t> edgeCaps;     ///< edge by edge
    std::map<std::uint32_t, OfEdge> crowded; ///< by edge, those of more than two caps
    std::vector<std::uint8_t> flat;          ///< by edge, whether it has no record
    /// By cap, edges that list it first, and those of them that have no record.
    std::vector<std::uint8_t> edgesFrom, flatFrom;

    std::span<const std::uint32_t> capsOf(std::uint32_t edge) const {
        return std::span(edgeCaps).subspan(capsOfEdge[edge].first, capsOfEdge[edge].count);
    }

    /// Whether cutRecords() applies: all casters are opaque, and their clusters may be merged into
    /// one of closed and one of open components, because all but the largest are small together.
    bool canFollowCuts() const;
};

/// The records and topology of a rigid batch without simplified casters. `shadow`: its records,
/// made by buildPlanePairs() without a flat tolerance; null: not made yet. `topology`: of all its
/// triangles, if known; used if all of them cast.
UncutRecords uncutRecords(const Batch& batch, const std::vector<Material>& materials,
                          bool castMasked, std::shared_ptr<const PlanePairShadow> shadow = {},
                          std::optional<MeshTopology> topology = {});

} // namespace edgeshade
