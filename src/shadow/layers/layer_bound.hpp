#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/lights/light.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// Most groups of casters: each costs a pass over the scene.
inline constexpr std::size_t mostGroups = 64;

/// Bound of the number of shadow volumes around one point. The stencil counts exactly the casting
/// triangles between a point and the light, so this bounds the counter.
struct LayerBound {
    /// No straight line from the light, up to its range, meets more casting triangles than this.
    std::size_t most = 0;
    /// If `most` is above the limit, the group of each casting triangle (in the order of batches
    /// and their casters), such that no line meets more than `limit` triangles of one group. A
    /// place of a mesh stored once is wholly in one group where possible. Otherwise empty.
    std::vector<std::uint32_t> groupOf;
    std::size_t groupCount = 1;
    /// More than mostGroups would be needed, so there is a single group: too many triangles are
    /// behind each other, or computing the bound was abandoned. A point shaded by a multiple of 256
    /// triangles would come out lit.
    bool mayOverflow = false;
};

/// Bounds the layers around each light by crowdedDirections(), and finds groups. Costs nothing for
/// scenes of at most `limit` triangles. For several lights the bound holds for every line from any
/// of them, and they share the groups. LayerSearch is faster where no groups are needed.
LayerBound boundByTriangles(const Scene& scene, bool castMasked, std::span<const Light> lights,
                            std::size_t limit);

} // namespace edgeshade
