#include "src/cli/sensor_rays.hpp"

#include "src/hours/surfaces/sensor_rays.hpp"
#include "src/lab/texture_alpha.hpp"

#include <memory>

namespace edgeshade::cli {
namespace {

rays::IsHole holesOf(const LoadedScene& loaded) {
    if (!loaded.cutoutsCast) return {};
    return [&materials = loaded.scene.materials, alpha = lab::textureAlpha(loaded)](
               const rays::SurfaceTriangle& triangle, double u, double v) {
        return alpha.cutsOut(materials, triangle, u, v);
    };
}

} // namespace

hours::SensorLight sensorLight(const LoadedScene& loaded) {
    const auto rays = std::make_shared<hours::SensorRays>(loaded.scene, loaded.settings.castMasked,
                                                          loaded.cutoutsCast, holesOf(loaded));
    return [rays](std::span<const hours::Sensor> sensors, std::span<const glm::dvec3> directions) {
        return rays->lit(sensors, directions);
    };
}

} // namespace edgeshade::cli
