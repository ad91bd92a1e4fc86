#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// Converts a light of the file to one of a picture. Point lights and spots fall off with the
/// square of the distance.
Light lightOf(const SceneLight& light);

/// The scene's lights, at most mostLights; empty if the file has none.
std::vector<Light> lightsOf(const Scene& scene);

} // namespace edgeshade
