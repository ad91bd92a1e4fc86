#pragma once

#include "preprocess/scene/scene.hpp"
#include "src/shadow/lights/light.hpp"

namespace edgeshade {

/// A light of the file as one of a picture. Point lights and spots fall off with the square of the
/// distance.
Light lightOf(const SceneLight& light);

/// The scene's lights, mostLights of them at most; none where the file has none.
std::vector<Light> lightsOf(const Scene& scene);

} // namespace edgeshade
