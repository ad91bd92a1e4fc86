#pragma once

#include "src/hours/surfaces/sensor_light.hpp"
#include "src/scene/load.hpp"

namespace edgeshade::cli {

/// Light by rays, as the oracle defines it. The scene must outlive it. Throws
/// Error(unavailable) if the program was built without Embree; InputError.
hours::SensorLight sensorLight(const LoadedScene& loaded);

} // namespace edgeshade::cli
