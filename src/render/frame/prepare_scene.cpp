#include "src/render/frame/prepare_scene.hpp"

namespace edgeshade {
namespace {

std::vector<Light> drawnLights(const FrameView& view) {
    std::vector<Light> lights;
    for (const FrameLight& of : view.lights)
        if (of.drawn) lights.push_back(of.light);
    return lights;
}

} // namespace

void prepareScene(GpuScene& scene, const LoadedScene& loaded, const FrameView& view,
                  const RenderSettings& settings, const gl::Capabilities& capabilities) {
    if (settings.shadows == ShadowMethod::primitiveMap) {
        std::vector<bool> hidden;
        for (const GpuBatch& batch : scene.batches)
            hidden.push_back(batch.hidden);
        scene.primitiveMaps.make(loaded, hidden, drawnLights(view), settings.primitiveMap,
                                 capabilities);
    }
    if (const auto records = settings.records()) scene.groups.upload(loaded, view.lights, *records);
}

} // namespace edgeshade
