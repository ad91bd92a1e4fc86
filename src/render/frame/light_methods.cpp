#include "src/render/frame/light_methods.hpp"

#include <algorithm>

namespace edgeshade {

std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const Renderer& renderer) {
    std::vector<LightMethod> methods = lightMethods(scene, view, renderer.settings());
    if (renderer.settings().shadows == ShadowMethod::map)
        for (std::size_t i = 0; i < methods.size(); ++i)
            if (methods[i].method == "map")
                methods[i].bytes = renderer.mapBytesOf(view.lights[i].light);
    // What was decided as the last frame was planned.
    for (const SlicePlan& slice : renderer.plan().slices)
        for (std::size_t i = 0; i < std::min(methods.size(), slice.lights.size()); ++i) {
            const std::vector<CountPlan>& counts = slice.lights[i].counts;
            if (counts.empty() || !counts.front().byPoints) continue;
            if (methods[i].method == "primitive-map") continue; // what moves alone is asked about
            methods[i].method = "irregular-z-buffer";
            if (renderer.volumes())
                methods[i].why =
                    "it has no primitive map, and filling volumes is estimated to take "
                    "longer";
        }
    return methods;
}

} // namespace edgeshade
