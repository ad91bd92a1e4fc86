#pragma once

#include "src/hours/surfaces/sensor_light.hpp"
#include "src/scene/load.hpp"

namespace edgeshade::cli {

/// Light by certified rays (src/rays/), with cutouts if the scene's cast. Sensors light up from the
/// side of their normals alone, on surfaces that cast nothing too. The scene must outlive it.
/// Throws InputError.
hours::SensorLight sensorLight(const LoadedScene& loaded);

} // namespace edgeshade::cli
