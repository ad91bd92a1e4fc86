#pragma once

#include "src/shadow/view/framing.hpp"
#include "src/viewer/light_handles.hpp"

#include <functional>

namespace edgeshade::viewer {

/// Facts about the scene and the picture that interaction needs.
struct Stage {
    Box bounds; ///< the scene's, in the world; of the whole of it where it is cut
    int width = 1;
    int height = 1;
    double pixelRatio = 1.0;
    std::vector<Light> lights;  ///< the file's; empty: the default light is used
    std::size_t animations = 0; ///< number of the file's animations
    /// The first surface point on a ray; may be empty: no scene.
    std::function<std::optional<glm::dvec3>(const Ray&)> firstHit;

    /// See framingCamera(); may be empty: the bounds are framed.
    std::function<Camera(double fovDegrees, double aspect, const glm::dvec3& direction)> framing;

    /// A camera that shows the whole scene, seen from that direction.
    Camera framed(double fovDegrees, const glm::dvec3& direction) const {
        return framing ? framing(fovDegrees, aspect(), direction)
                       : framingCamera(bounds, fovDegrees, aspect(), direction);
    }
    double aspect() const { return static_cast<double>(width) / height; }
    /// The scene's size; 1 if it has none.
    double size() const { return bounds.diagonal() > 0.0 ? bounds.diagonal() : 1.0; }
    PictureView viewOf(const Camera& camera) const {
        return {camera, static_cast<double>(width), static_cast<double>(height)};
    }
    LightHandles handles() const { return LightHandles(bounds); }
};

} // namespace edgeshade::viewer
