#pragma once

#include "src/shadow/geometry/light.hpp"
#include "src/shadow/primitive_map/caster_edges.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace edgeshade {

/// One batch's casters, that rest.
struct CullingCasters {
    std::shared_ptr<const PlanePairShadow> shadow;
    PlacedCasters placed;             ///< casterEdgesOf() these records, and where they are
    std::vector<std::int8_t> facings; ///< LightFacings, of the light in the batch's space
};

/// Texels along a tile's edge, and what they are grown by for it, in texels: how far from a
/// blocker's outline whatever lies in its shadow is, at least.
struct CullingGrid {
    int size = 512; ///< a power of 2, >= 4
    double margin = 0.25;
};

/// By batch, by cap: 1 where all that is in its shadow is in the shadow of caps that are 0
/// (docs/method.md, C43). All are 0 where the light is too far from the casters to tell. Takes some
/// hundred milliseconds for 100,000 triangles.
std::vector<std::vector<std::uint8_t>> shadowedCasters(const Light& light,
                                                       const std::vector<CullingCasters>& casters,
                                                       const CullingGrid& grid = {});

} // namespace edgeshade
