#pragma once

#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/scene/scene.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade {

/// An object of "index" and "name" for each.
nlohmann::ordered_json partsJson(const std::vector<AnimationTitle>& animations);

/// An object of "name", "node", "from", "direction", and "fov" in degrees or "ortho" (height of the
/// picture in scene units) for each.
nlohmann::ordered_json partsJson(const std::vector<SceneCamera>& cameras);

/// An object of "name", "node", "type", "position", "direction", "color", "intensity", "range",
/// "cone": {"inner", "outer"} in degrees for each, as far as its type has them.
nlohmann::ordered_json partsJson(const std::vector<SceneLight>& lights);

/// "directional", "point" or "spot".
const char* nameOf(SceneLight::Kind kind);

} // namespace edgeshade
