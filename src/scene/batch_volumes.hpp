#pragma once

#include "src/scene/plane_pair_buffers.hpp"
#include "src/scene/record_source.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace edgeshade {

/// Records of a layout other than plane pairs, with what makes them again where a batch deforms.
struct FurtherRecords {
    VolumeRecords made;
    std::shared_ptr<RecordBuffers> buffers;
};

/// One batch's shadow data on the GPU, in one layout or several. Batches that share their geometry
/// share these.
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
