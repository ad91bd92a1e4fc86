#include "src/gl/headless_context.hpp"
#include "src/gl/objects.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/prepare_scene.hpp"
#include "tests/lab/extreme_check.hpp"
#include "tests/support/bounded_frame.hpp"

#include <cmath>
#include <GLES2/gl2.h>
#include <map>

namespace edgeshade::test {
namespace {

/// Reduces a deeper depth buffer to `bits` bits: Mesa has no 16-bit depth with a stencil. All
/// depths, including the cleared one, use only the front of its range.
void coarsenDepth(int bits, const gl::Capabilities& capabilities) {
    if (capabilities.depthBits <= bits) return;
    const float farthest = std::ldexp(1.0f, bits - capabilities.depthBits);
    glDepthRangef(0.0f, farthest);
    glClearDepthf(farthest);
}

} // namespace

lab::Pictures drawPictures(const Extreme& extreme, const LoadedScene& scene,
                           const RenderSettings& settings, double& near) {
    const gl::HeadlessContext context(
        {extreme.width, extreme.height, 0, gl::Limits::device, extreme.depthBits});
    const gl::Capabilities& capabilities = context.capabilities();
    coarsenDepth(extreme.depthBits, capabilities);
    RenderSettings shadows = settings, plain;
    shadows.layout = plain.layout = bestLayout(capabilities);
    plain.shadows = ShadowMethod::none;
    FrameView frame = test::boundedFrame(
        scene.scene, scene.settings.castMasked,
        {extreme.seen(), extreme.width, extreme.height, extreme.lights, extreme.depth});
    near = frame.near();
    GpuScene gpu = uploadScene(scene, shadows.records(), capabilities);
    prepareScene(gpu, scene, frame, Renderer(shadows, capabilities));
    const auto draw = [&](const RenderSettings& drawn, const FrameView& view) {
        Renderer(drawn, capabilities).draw(gpu, view);
        gl::requireNoError("drawing an extreme");
        return context.readPixels();
    };

    lab::Pictures pictures;
    std::map<lab::LightSet, std::vector<std::uint8_t>> unshadowed;
    for (std::uint32_t lights = 0; lights < 1u << frame.lights.size(); ++lights) {
        FrameView view = frame;
        for (std::size_t i = 0; i < view.lights.size(); ++i)
            view.lights[i].drawn = (lights >> i & 1u) != 0;
        unshadowed[lights] = draw(plain, view);
    }
    pictures.unshadowed = [unshadowed](const lab::LightSet& lights) {
        return unshadowed.at(lights);
    };
    pictures.image = draw(shadows, frame);
    frame.mask = true;
    pictures.mask = draw(shadows, frame);
    return pictures;
}

} // namespace edgeshade::test
