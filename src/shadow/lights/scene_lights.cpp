#include "src/shadow/lights/scene_lights.hpp"

#include <algorithm>

namespace edgeshade {

Light lightOf(const SceneLight& light) {
    Light made;
    made.color = glm::vec3(light.intensity * light.color);
    made.photometric = true;
    if (light.kind == SceneLight::Kind::directional) {
        made.position = glm::dvec4(-light.direction, 0.0);
        return made;
    }
    made.position = glm::dvec4(light.position, 1.0);
    made.range = light.range;
    if (light.kind == SceneLight::Kind::spot)
        made.cone = Cone{light.direction, light.innerCone, light.outerCone};
    return made;
}

std::vector<Light> lightsOf(const Scene& scene) {
    std::vector<Light> lights;
    for (std::size_t i = 0; i < std::min(scene.lights.size(), mostLights); ++i)
        lights.push_back(lightOf(scene.lights[i]));
    return lights;
}

} // namespace edgeshade
