#include "tests/support/headless.hpp"

#include "src/render/frame/prepare_scene.hpp"
#include "src/rivals/rivals.hpp"
#include "src/scene/shadow_facts.hpp"
#include "src/shadow/view/light_budget.hpp"
#include "tests/support/bounded_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <EGL/egl.h>
#include <memory>
#include <string_view>

namespace edgeshade::test {

gl::Limits testLimits() {
    const char* word = std::getenv(limitsVariable);
    return word && std::string_view(word) == "es2-minimum" ? gl::Limits::es2Minimum
                                                           : gl::Limits::device;
}

bool drawsOnProcessor() {
    static const bool software = gl::HeadlessContext(testPicture(1, 1)).capabilities().isSoftware();
    return software;
}

bool canAskPoints() {
    static const bool can =
        ShadowPolicy({.asked = ShadowMethod::irregularZBuffer},
                     deviceFactsOf(gl::HeadlessContext(testPicture(1, 1)).capabilities()), {})
            .mayAskPoints();
    return can;
}

bool hasDerivatives() {
    return testLimits() == gl::Limits::device;
}

gl::HeadlessContext::Request testPicture(int width, int height, int samples) {
    return {width, height, samples, testLimits()};
}

namespace {

/// Records of casters that are treated as double-sided.
std::vector<std::shared_ptr<const PlanePairShadow>> uncullable(Scene scene, bool castMasked) {
    for (Material& material : scene.materials)
        material.doubleSided = true;
    return buildPlanePairs(scene, castMasked);
}

/// A context for a picture of this size. It is kept for the next picture while it stays current,
/// since making one takes longer than most tests draw. Where the caller has one of its own, it is a
/// new one, and the caller's is current again after it.
std::shared_ptr<const gl::HeadlessContext> contextFor(int width, int height) {
    struct Kept {
        int width, height;
        gl::HeadlessContext context;
        EGLContext handle = eglGetCurrentContext();

        Kept(int w, int h) : width(w), height(h), context(testPicture(w, h)) {}
    };
    static std::shared_ptr<Kept> kept;
    const EGLContext current = eglGetCurrentContext();
    const bool isKept = kept && current == kept->handle;
    if (current && !isKept)
        return std::make_shared<gl::HeadlessContext>(testPicture(width, height));
    if (!isKept || kept->width != width || kept->height != height) {
        kept.reset();
        kept = std::make_shared<Kept>(width, height);
    }
    return {kept, &kept->context};
}

} // namespace

std::vector<std::uint8_t> drawScene(const Scene& scene, const TestView& test,
                                    RenderSettings settings, bool castMasked) {
    const auto held = contextFor(test.width, test.height);
    const gl::HeadlessContext& context = *held;
    if (!context.capabilities().instancing) settings.layout = SidesLayout::notInstanced;
    settings.rivals = &allRivals();
    const LoadedScene loaded{
        {},
        scene,
        test.images,
        test.culledCaps ? buildPlanePairs(scene, castMasked) : uncullable(scene, castMasked),
        {},
        {0.0, castMasked}};
    FrameView view =
        test::boundedFrame(loaded.scene, loaded.settings.castMasked,
                           {test.seen(), test.width, test.height, test.lights, test.depth});
    view.mask = test.mask;
    if (test.drawnLights)
        for (std::size_t i = 0; i < view.lights.size(); ++i)
            view.lights[i].drawn =
                std::count(test.drawnLights->begin(), test.drawnLights->end(), i);
    if (settings.shadowedLights) keepShadowed(view, *settings.shadowedLights);
    if (!test.nearDiscard) view.nearestDepths.assign(scene.batches.size(), INFINITY);
    GpuScene gpu = uploadScene(loaded, settings.records(), context.capabilities());
    Renderer renderer(settings, context.capabilities());
    prepareScene(gpu, loaded, view, renderer);
    renderer.draw(gpu, view);
    gl::requireNoError("drawing a test scene");
    return context.readPixels();
}

} // namespace edgeshade::test
