#pragma once

#include "src/scene/gpu_scene.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// One of a light's groups of casters in a depth slice.
struct CasterGroupInSlice {
    const FrameView& view;
    const DepthSlice& slice;
    std::size_t light = 0; ///< index in the view
    std::size_t group = 0;
    bool lookedUp = false; ///< static casters are in the light's primitive map, here
                           ///< or in a host's shader

    const FrameLight& source() const { return view.lights[light]; }
    bool counts(const GpuBatch& batch) const {
        return !batch.hidden && (!lookedUp || batch.animated);
    }
};

} // namespace edgeshade
