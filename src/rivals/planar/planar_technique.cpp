#include "src/rivals/planar/planar_technique.hpp"

#include "src/scene/load.hpp"

#include <cmath>

namespace edgeshade {

void PlanarTechnique::prepareScene(const GpuScene& scene, const LoadedScene& loaded) {
    if (scene_ == scene.identity) return;
    planes_ = ShadowPlanes(loaded, count_);
    scene_ = scene.identity;
}

void PlanarTechnique::describe(const GpuScene&, const Light&, LightMethod& method) const {
    const std::size_t count = planes_.all().size();
    method.why = "onto " + std::to_string(count) +
                 (count == 1 ? " plane only, which has " : " planes only, which have ") +
                 std::to_string(std::lround(100.0 * planes_.share())) + " % of all surfaces' area";
    method.buildMs = planes_.buildMs();
    method.bytes = planes_.bytes();
}

} // namespace edgeshade
