#include "src/render/shadow_map/pcss_view.hpp"

#include "src/shadow/lights/light_extent.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

PcssLight pcssLight(const Light& light, const ShadowMapView& view) {
    const LightExtent& extent = *light.extent;
    const glm::dvec3 scale = view.scale();
    PcssLight pcss;
    pcss.shape = extent.shape;
    pcss.nearestCaster = static_cast<float>(view.near);
    double smallest = 0.0;
    switch (extent.shape) {
    case LightExtent::Shape::disc:
        smallest = std::tan(extent.radius);
        pcss.radius = static_cast<float>(smallest);
        pcss.leastSpread = static_cast<float>(view.texel / smallest);
        return pcss;
    case LightExtent::Shape::sphere:
        smallest = extent.radius * scale.x;
        pcss.radius = static_cast<float>(smallest);
        break;
    case LightExtent::Shape::rectangle: {
        const auto [across, up] = rectangleAxes(extent.direction);
        pcss.across = glm::vec3(0.5 * extent.size.x * scale.x * across);
        pcss.up = glm::vec3(0.5 * extent.size.y * scale.x * up);
        pcss.facing = glm::vec3(extent.direction);
        smallest = 0.5 * std::min(extent.size.x, extent.size.y) * scale.x;
        break;
    }
    }
    pcss.leastSpread = static_cast<float>(view.step / smallest);
    return pcss;
}

} // namespace edgeshade
