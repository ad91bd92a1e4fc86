#include "src/cli/sensor_rays.hpp"

#include "preprocess/base/error.hpp"

#ifdef EDGESHADE_HAS_LAB
#include "src/lab/sun_probe.hpp"
#include "src/lab/texture_alpha.hpp"
#endif

namespace edgeshade::cli {

#ifdef EDGESHADE_HAS_LAB

hours::SensorLight sensorLight(const LoadedScene& loaded) {
    return [&loaded, alpha = lab::textureAlpha(loaded)](std::span<const hours::Sensor> sensors,
                                                        std::span<const glm::dvec3> directions) {
        hours::LitBits bits(sensors.size(), directions.size());
        for (std::size_t i = 0; i < sensors.size(); ++i) {
            const std::vector<bool> seen =
                lab::seenFrom(loaded, alpha, sensors[i].point, sensors[i].normal, directions);
            for (std::size_t d = 0; d < seen.size(); ++d)
                if (seen[d]) bits.set(i, d);
        }
        return bits;
    };
}

#else

hours::SensorLight sensorLight(const LoadedScene&) {
    throw Error(ExitStatus::unavailable,
                "sunhours --surfaces traces rays, but this program was built without Embree.");
}

#endif

} // namespace edgeshade::cli
