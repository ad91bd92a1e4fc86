#pragma once

#include "src/scene/plane_pair_buffers.hpp"
#include "src/scene/record_source.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace edgeshade {

/// Records in a layout other than plane pairs, and the source that makes them again when a batch
/// deforms.
struct FurtherRecords {
    VolumeRecords made;
    std::shared_ptr<RecordBuffers> buffers;
};

/// One batch's shadow data on the GPU, in one or more layouts. Batches with the same geometry share
/// them.
struct BatchVolumes {
    std::shared_ptr<PlanePairBuffers> planePairs; ///< null: not uploaded
    std::vector<FurtherRecords> further{};        ///< at most one of each layout

    /// Null where there are none in that layout.
    RecordBuffers* recordsOf(VolumeLayout layout) const {
        const auto found =
            std::find_if(further.begin(), further.end(),
                         [&](const FurtherRecords& of) { return of.made.volumes == layout; });
        return found != further.end() ? found->buffers.get() : nullptr;
    }
    bool has(VolumeLayout layout) const {
        return layout == VolumeLayout::planePairs ? planePairs != nullptr
                                                  : recordsOf(layout) != nullptr;
    }

    std::size_t sideBytes() const {
        std::size_t total = planePairs ? planePairs->sideBytes() : 0;
        for (const FurtherRecords& of : further)
            total += of.buffers->sideBytes();
        return total;
    }
    std::size_t capBytes() const {
        std::size_t total = planePairs ? planePairs->capBytes() : 0;
        for (const FurtherRecords& of : further)
            total += of.buffers->capBytes();
        return total;
    }
    std::size_t bytes() const { return sideBytes() + capBytes(); }
};

} // namespace edgeshade
