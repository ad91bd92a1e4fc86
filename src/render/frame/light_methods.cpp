#include "src/render/frame/light_methods.hpp"

#include "src/render/frame/frame.hpp"
#include "src/scene/shadow_facts.hpp"

namespace edgeshade {

std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const Renderer& renderer) {
    const Techniques& techniques = renderer.techniques();
    const ShadowTechnique* lookups = techniques.of(Technique::lookup);
    const ShadowPolicy policy = renderer.policyFor(sceneFactsOf(scene));
    std::vector<LightMethod> methods;
    for (const FrameLight& of : view.lights) {
        const LightFacts light = lightFactsOf(of);
        const LookupFacts lookup = lookupFactsOf(scene, of.light);
        const LightChoice choice = policy.choose(light, lookup);
        LightMethod& method = methods.emplace_back();
        method.method = wordFor(choice.technique);
        method.rule = choice.rule;
        method.why = policy.reasonFor(light, lookup);
        const ShadowTechnique* technique = techniques.of(choice.technique);
        if (technique) technique->describe(scene, of.light, method);
        // Report a refused map too: building it took time.
        if (lookups && lookups != technique && of.drawn && of.shadowed)
            lookups->describe(scene, of.light, method);
    }
    return methods;
}

} // namespace edgeshade
