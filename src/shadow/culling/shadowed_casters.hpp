#pragma once

#include "preprocess/base/box.hpp"
#include "preprocess/base/parallel.hpp"
#include "src/shadow/geometry/light.hpp"
#include "src/shadow/primitive_map/caster_edges.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace edgeshade {

/// One batch's casters, that rest.
struct CullingCasters {
    std::shared_ptr<const PlanePairShadow> shadow;
    PlacedCasters placed;             ///< casterEdgesOf() these records, and where they are
    std::vector<std::int8_t> facings; ///< LightFacings, of all of the light in the batch's space
};

/// How casters are culled.
struct CullingSettings {
    int size = 512; ///< texels along a tile's edge; a power of 2, >= 4
    /// What they are grown by, in texels: how far from a blocker's outline whatever lies in its
    /// shadow is, at least.
    double margin = 0.25;
    Box receivers{}; ///< all that the light shines on, in the world; of a light with an extent
    Threads threads{};
    std::function<bool()> givenUp{}; ///< asked now and then: true ends it, and all are 0
};

/// By batch, by cap: 1 where all that is in its shadow is in the shadow of caps that are 0
/// (docs/method.md, C43). A light with an extent stands for one that may be at any place of it:
/// that is so at each of them. All are 0 where the light is too far from the casters to tell. Takes
/// some hundred milliseconds for 100,000 triangles.
std::vector<std::vector<std::uint8_t>> shadowedCasters(const Light& light,
                                                       const std::vector<CullingCasters>& casters,
                                                       const CullingSettings& settings = {});

} // namespace edgeshade
