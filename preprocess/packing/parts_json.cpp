#include "preprocess/packing/parts_json.hpp"

#include "preprocess/base/names.hpp"

#include <cmath>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace

const char* nameOf(SceneLight::Kind kind) {
    using enum SceneLight::Kind;
    return nameIn({{directional, "directional"}, {point, "point"}, {spot, "spot"}}, kind);
}

Json partsJson(const std::vector<AnimationTitle>& animations) {
    Json all = Json::array();
    for (const AnimationTitle& title : animations)
        all.push_back({{"index", title.index}, {"name", title.name}});
    return all;
}

Json partsJson(const std::vector<SceneCamera>& cameras) {
    Json all = Json::array();
    for (const SceneCamera& camera : cameras) {
        Json one = {{"name", camera.name},
                    {"node", camera.nodeName},
                    {"from", toJson(glm::dvec3(camera.worldFromCamera[3]))},
                    {"direction", toJson(glm::dvec3(-camera.worldFromCamera[2]))}};
        if (camera.orthographic)
            one["ortho"] = camera.height;
        else
            one["fov"] = glm::degrees(camera.height);
        all.push_back(one);
    }
    return all;
}

Json partsJson(const std::vector<SceneLight>& lights) {
    Json all = Json::array();
    for (const SceneLight& light : lights) {
        Json one = {{"name", light.name}, {"node", light.nodeName}, {"type", nameOf(light.kind)}};
        if (light.kind != SceneLight::Kind::directional) one["position"] = toJson(light.position);
        if (light.kind != SceneLight::Kind::point) one["direction"] = toJson(light.direction);
        one["color"] = toJson(light.color);
        one["intensity"] = light.intensity;
        if (std::isfinite(light.range)) one["range"] = light.range;
        if (light.kind == SceneLight::Kind::spot)
            one["cone"] = {{"inner", glm::degrees(light.innerCone)},
                           {"outer", glm::degrees(light.outerCone)}};
        all.push_back(one);
    }
    return all;
}

} // namespace edgeshade
