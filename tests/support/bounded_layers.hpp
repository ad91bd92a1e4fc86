#pragma once

#include "src/shadow/layers/layer_search.hpp"

namespace edgeshade::test {

/// LayerSearch::bound(), for a single search.
inline LayerBound boundLayers(const LayerCasters& casters, std::span<const Light> lights,
                              std::size_t limit) {
    return LayerSearch().bound(casters, lights, limit);
}
inline LayerBound boundLayers(const LayerCasters& casters, const Light& light, std::size_t limit) {
    return boundLayers(casters, std::span(&light, 1), limit);
}

} // namespace edgeshade::test
