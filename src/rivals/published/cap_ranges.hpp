#pragma once

#include "preprocess/mesh/topology.hpp"

#include <optional>
#include <vector>

namespace edgeshade {

/// Neighbouring caps that are drawn together.
struct CapRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::optional<std::size_t> alphaTested; ///< the material, if caps are alpha-tested
};

/// Divides caps by how they are drawn: adjoining groups of opaque casters together, others
/// separately.
inline std::vector<CapRange> capRanges(const std::vector<MaterialCasters>& groups,
                                       const std::vector<Material>& materials) {
    std::vector<CapRange> ranges;
    bool afterOpaque = false;
    for (const MaterialCasters& group : groups) {
        const bool opaque = materials[group.material].alphaMode == AlphaMode::opaque;
        if (opaque && afterOpaque) {
            ranges.back().count += group.capCount;
            continue;
        }
        afterOpaque = opaque;
        CapRange& range = ranges.emplace_back(CapRange{group.firstCap, group.capCount, {}});
        if (!opaque) range.alphaTested = group.material;
    }
    return ranges;
}

} // namespace edgeshade
