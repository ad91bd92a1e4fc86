#include "src/render/frame/light_methods.hpp"

namespace edgeshade {

std::vector<LightMethod> lightMethods(const GpuScene& scene, const FrameView& view,
                                      const Renderer& renderer) {
    std::vector<LightMethod> methods = lightMethods(scene, view, renderer.settings());
    if (renderer.settings().shadows == ShadowMethod::map)
        for (std::size_t i = 0; i < methods.size(); ++i)
            if (methods[i].method == "map")
                methods[i].bytes = renderer.mapBytesOf(view.lights[i].light);
    return methods;
}

} // namespace edgeshade
