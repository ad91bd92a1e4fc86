#include "src/shadow/view/scene_cameras.hpp"

#include "preprocess/base/vectors.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace edgeshade {

const SceneCamera* findCamera(const std::vector<SceneCamera>& cameras,
                              const std::string& nameOrIndex) {
    for (const auto name : {&SceneCamera::name, &SceneCamera::nodeName}) {
        const auto found =
            std::find_if(cameras.begin(), cameras.end(),
                         [&](const SceneCamera& camera) { return camera.*name == nameOrIndex; });
        if (found != cameras.end() && !nameOrIndex.empty()) return &*found;
    }
    std::size_t index = 0;
    const char* const end = nameOrIndex.data() + nameOrIndex.size();
    const auto result = std::from_chars(nameOrIndex.data(), end, index);
    const bool isIndex = result.ec == std::errc() && result.ptr == end && index < cameras.size();
    return isIndex ? &cameras[index] : nullptr;
}

std::string titleOf(const std::vector<SceneCamera>& cameras, std::size_t index) {
    const SceneCamera& camera = cameras[index];
    if (!camera.name.empty()) return camera.name;
    return camera.nodeName.empty() ? std::to_string(index) : camera.nodeName;
}

Frustum frustumOf(const SceneCamera& camera, double aspect) {
    Frustum frustum;
    const glm::dmat3 viewFromWorld = glm::transpose(glm::dmat3(camera.worldFromCamera));
    frustum.viewFromWorld = glm::dmat4(viewFromWorld);
    frustum.viewFromWorld[3] =
        glm::dvec4(-(viewFromWorld * glm::dvec3(camera.worldFromCamera[3])), 1.0);
    frustum.orthographic = camera.orthographic;
    const double half = camera.orthographic ? 0.5 * camera.height : std::tan(0.5 * camera.height);
    frustum.high = {half * aspect, half};
    frustum.low = -frustum.high;
    return frustum;
}

Camera uprightCamera(const SceneCamera& camera, const Box& bounds) {
    const glm::dvec3 from(camera.worldFromCamera[3]), forward(-camera.worldFromCamera[2]);
    const double size = bounds.empty() ? 1.0 : bounds.diagonal();
    const double ahead = bounds.empty() ? 1.0 : glm::dot(bounds.center() - from, forward);
    const double place = largestComponent(from);
    const double distance = std::max({ahead, 0.01 * size, 1e-6 * place, 1e-9});
    return {from, from + distance * forward, glm::degrees(camera.height)};
}

std::vector<FileCamera> fileCameras(const Scene& scene) {
    const Box bounds = worldBounds(scene);
    std::vector<FileCamera> shown;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        if (!scene.cameras[i].orthographic)
            shown.push_back({titleOf(scene.cameras, i), uprightCamera(scene.cameras[i], bounds)});
    return shown;
}

} // namespace edgeshade
