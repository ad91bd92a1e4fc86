#pragma once

#include "src/shadow/view/frame_view.hpp"

namespace edgeshade::test {

/// makeFrameView() with layers bounded in time linear in the triangles, for a single frame.
/// `castMasked` as in CasterSettings.
inline FrameView boundedFrame(const Scene& scene, bool castMasked, const FrameRequest& request) {
    FrameView view = makeFrameView(scene, request, worldBounds(scene));
    for (FrameLight& of : view.lights)
        of.layers = boundByTriangles(scene, castMasked, of.counted(), stencilLimit);
    return view;
}

} // namespace edgeshade::test
