#include "src/cli/explanation.hpp"

#include "src/render/accumulation/extended_lights.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/light_methods.hpp"
#include "src/rivals/maps/map_filters.hpp"
#include "src/shadow/plan/explain.hpp"

#include <cmath>

namespace edgeshade::cli {
namespace {

/// Describes which lights are looked up in primitive maps, and why the others are not.
std::string methodsOf(const Renderer& renderer, const GpuScene& scene, const FrameView& view) {
    std::string text;
    const std::vector<LightMethod> methods = lightMethods(scene, view, renderer);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const LightMethod& of = methods[i];
        text += "light " + std::to_string(i) + ": ";
        if (of.method == "primitive-map")
            text += "primitive map: " + std::to_string(of.bytes) + " bytes, built in " +
                    std::to_string(std::lround(of.buildMs)) + " ms";
        else
            text += (of.method == "irregular-z-buffer" ? "irregular z-buffer: "
                     : of.method == "none"             ? "no shadow: "
                                                       : "volumes: ") +
                    of.why;
        text += " (rule: " + of.rule + ")\n";
    }
    return text;
}

/// Describes each light's map.
std::string mapsOf(const Renderer& renderer, const GpuScene& scene, const FrameView& view) {
    std::string text = "shadow maps: every light draws all casters into each part of its map";
    const std::vector<LightMethod> methods = lightMethods(scene, view, renderer);
    for (std::size_t i = 0; i < methods.size(); ++i)
        text += "\nlight " + std::to_string(i) + ": " + methods[i].why + ", " +
                std::to_string(methods[i].bytes) + " bytes";
    if (const std::size_t all = renderer.mapBytes(); isFiltered(renderer.settings().map))
        text += "\nall maps and their filters: " + std::to_string(all) + " bytes";
    return text;
}

/// Describes how each triangle's volume is counted, from the plan.
std::string bruteForceOf(const FramePlan& plan) {
    std::string text = "brute force: one volume for each triangle";
    for (std::size_t s = 0; s < plan.slices.size(); ++s)
        for (std::size_t i = 0; i < plan.slices[s].lights.size(); ++i) {
            const auto& counts = plan.slices[s].lights[i].counts;
            if (counts.empty()) continue;
            const auto& draws = counts.front().draws.once;
            const bool zFail = draws.empty() || draws.front().zFail;
            text += "\nslice " + std::to_string(s) + ", light " + std::to_string(i) + ": " +
                    (zFail ? "z-fail with caps" : "z-pass, near caps from the light (ZP+)");
        }
    return text;
}

} // namespace

std::string explanationOf(const Renderer& renderer, const GpuScene& scene, const FrameView& view) {
    const RenderSettings& settings = renderer.settings();
    std::string methods;
    switch (settings.shadows) {
    case ShadowMethod::none:
        return "no shadows are drawn";
    case ShadowMethod::map:
        return mapsOf(renderer, scene, view);
    case ShadowMethod::irregularZBuffer:
        return "irregular z-buffer: no volumes are drawn; the processor tests whether a caster "
               "lies between each visible point and the light";
    case ShadowMethod::planar:
        return "planar: all casters are projected " +
               lightMethods(scene, view, renderer).front().why + ", " +
               std::to_string(renderer.mapBytes()) + " bytes";
    case ShadowMethod::automatic:
    case ShadowMethod::primitiveMap:
        methods = methodsOf(renderer, scene, view);
        break;
    case ShadowMethod::volumes:
        break;
    }
    if (ExtendedLights::points(view) > 0)
        methods += "each light with an extent is the sum of its points; of the last pass:\n";
    if (renderer.volumes()->layout() == VolumeLayout::triangles)
        return methods + bruteForceOf(renderer.plan());
    if (renderer.volumes()->layout() == VolumeLayout::oppositeVertices)
        return methods + "opposite-vertex records: every edge and all caps of every light, z-fail";
    return methods + explain(renderer.plan(), view);
}

} // namespace edgeshade::cli
