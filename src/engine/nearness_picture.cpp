#include "src/engine/nearness_picture.hpp"

namespace edgeshade {

void NearnessPicture::draw(Renderer& renderer, const GpuScene& scene, const FrameView& view,
                           const Frustum& asked, const gl::DepthStencil* shared) {
    target_.bind(view.width, view.height, shared);
    renderer.drawNearness(scene, view);
    told_.texture = target_.texture();
    told_.scale = view.near();
    told_.offset = 0.0;
    if (!view.frustum.orthographic) return;
    const double back = asked.viewFromWorld[3].z - view.frustum.viewFromWorld[3].z;
    told_.scale = -1.0 / (view.farPlane - view.near());
    told_.offset = (back - view.farPlane) * told_.scale;
}

} // namespace edgeshade
