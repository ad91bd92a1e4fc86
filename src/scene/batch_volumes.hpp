#pragma once

#include "src/scene/adapted_buffers.hpp"
#include "src/scene/shadow_buffers.hpp"

#include <compare>
#include <optional>

namespace edgeshade {

/// What shadow volumes are drawn from.
enum class VolumeLayout {
    adapted,   ///< records that hold what the scene requires: preprocess/volumes/adapted_data.hpp
    published, ///< one global multiplicity, every edge, opposite vertices: the baseline
};

/// Which records are on the GPU, and how they reach the vertex shader.
struct VolumeRecords {
    VolumeLayout volumes = VolumeLayout::adapted;
    SidesLayout layout = SidesLayout::instanced;

    auto operator<=>(const VolumeRecords&) const = default;
};

/// One batch's shadow data on the GPU, in one of the layouts or several.
struct BatchVolumes {
    std::optional<AdaptedBuffers> adapted;
    std::optional<ShadowBuffers> published;

    std::size_t sideBytes() const {
        return (adapted ? adapted->sideBytes() : 0) + (published ? published->sideBytes() : 0);
    }
    std::size_t capBytes() const {
        return (adapted ? adapted->capBytes() : 0) + (published ? published->capBytes() : 0);
    }
    std::size_t bytes() const { return sideBytes() + capBytes(); }
};

} // namespace edgeshade
