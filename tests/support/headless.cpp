#include "tests/support/headless.hpp"

#include "src/gl/headless_context.hpp"
#include "src/render/near_plane.hpp"

namespace edgeshade::test {

std::vector<std::uint8_t> drawScene(const Scene& scene, FrameView view, RenderSettings settings,
                                    bool castMasked) {
    const gl::HeadlessContext context({view.width, view.height});
    if (!context.capabilities().instancing) settings.layout = SidesLayout::notInstanced;
    const double aspect = static_cast<double>(view.width) / view.height;
    if (view.nearestDepths.empty())
        for (const Batch& batch : scene.batches)
            view.nearestDepths.push_back(nearestVisibleDepth(batch, view.camera, aspect));
    if (view.near == 0.0) view.near = fittedNear(view.nearestDepths, worldBounds(scene).diagonal());
    const LoadedScene loaded{{}, scene, buildShadows(scene, castMasked), {0.0, castMasked}};
    const GpuScene gpu = uploadScene(loaded, settings.layout, context.capabilities());
    Renderer renderer(settings, context.capabilities());
    renderer.draw(gpu, view);
    gl::requireNoError("drawing a test scene");
    return context.readPixels();
}

FrameView viewOf(const Camera& camera, const Light& light, int width, int height) {
    return {camera, width, height, 0.0, {}, {light}};
}

} // namespace edgeshade::test
