#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/lights/light.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade {

/// Groups that casters are divided into at most: each costs a pass over the scene.
inline constexpr std::size_t mostGroups = 64;

/// How many shadow volumes can lie around one point: the stencil counts exactly the casting
/// triangles between a point and the light, so this bounds the counter.
struct LayerBound {
    /// No straight line from the light, as long as its range, meets more casting triangles than
    /// this.
    std::size_t most = 0;
    /// Where `most` is above the limit: for each casting triangle (in the order of batches and
    /// their casters) the group it is counted in, so that no line meets more than `limit`
    /// triangles of one group. All of a place of a mesh that is kept once is in one group, where
    /// that can be. Empty otherwise.
    std::vector<std::uint32_t> groupOf;
    std::size_t groupCount = 1;
    /// More than mostGroups would be needed, so there is one: as many triangles may lie behind each
    /// other, or the bound was given up. What a multiple of 256 triangles shade would come out lit.
    bool mayOverflow = false;
};

/// Bounds the layers around each light by crowdedDirections(). Free for scenes of at most `limit`
/// triangles.
/// Of several lights: no line from any of them meets more, and the groups are the same for all.
LayerBound boundLayers(const Scene& scene, bool castMasked, std::span<const Light> lights,
                       std::size_t limit);
inline LayerBound boundLayers(const Scene& scene, bool castMasked, const Light& light,
                              std::size_t limit) {
    return boundLayers(scene, castMasked, std::span(&light, 1), limit);
}

} // namespace edgeshade
