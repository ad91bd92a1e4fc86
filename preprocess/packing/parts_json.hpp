#pragma once

#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/scene/scene.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade {

/// {"index", "name"} of each.
nlohmann::ordered_json partsJson(const std::vector<AnimationTitle>& animations);

/// {"name", "node", "from", "direction", and "fov" in degrees or "ortho", the picture's height in
/// scene units} of each.
nlohmann::ordered_json partsJson(const std::vector<SceneCamera>& cameras);

/// {"name", "node", "type", "position", "direction", "color", "intensity", "range", "cone":
/// {"inner", "outer"} in degrees} of each, as far as its type has them.
nlohmann::ordered_json partsJson(const std::vector<SceneLight>& lights);

/// "directional", "point" or "spot".
const char* nameOf(SceneLight::Kind kind);

} // namespace edgeshade
