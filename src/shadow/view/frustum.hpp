#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/view/camera.hpp"

#include <limits>
#include <optional>

namespace edgeshade {

/// The view of a picture: a camera's place and rotation, and its window, anywhere across the
/// viewing direction. The depth range is not part of it.
struct Frustum {
    glm::dmat4 viewFromWorld{1.0}; ///< rigid: x right, y up, looking along -z
    /// The window's lower left and upper right corner. Perspective: x and y per unit of depth.
    /// Orthographic: x and y at any depth. high > low.
    glm::dvec2 low{-1.0}, high{1.0};
    bool orthographic = false;

    bool operator==(const Frustum&) const = default;
    glm::dvec2 size() const { return high - low; }
    /// x and y of a picture point, (-1, -1) to (1, 1): per unit of depth, or at any depth.
    glm::dvec2 windowAt(const glm::dvec2& point) const {
        return 0.5 * (low + high) + 0.5 * point * size();
    }
    glm::dvec3 position() const; ///< in the world
    glm::dvec3 forward() const;  ///< the viewing direction in the world, of length 1
    /// The common origin of all rays of the picture, in the world: the position, or, at infinity (w
    /// = 0), the direction opposite to the viewing direction.
    glm::dvec4 eye() const;
};

/// The frustum of a camera, for a picture with this aspect (width over height). If `height` is
/// given, an orthographic one that is as high in scene units, whatever the camera's field of view.
Frustum frustumOf(const Camera& camera, double aspect, std::optional<double> height = {});

/// The frustum of another engine's camera: its view matrix and its projection, perspective (also
/// off-axis) or orthographic, to GL's clip space. The projection's depth range is ignored. A
/// uniform scale of the view is removed. Throws Error(usage) that names what is wrong with a
/// matrix: numbers that aren't finite, a view that shears or mirrors, a projection of neither kind.
Frustum frustumOf(const glm::dmat4& viewFromWorld, const glm::dmat4& clipFromView);

/// The rigid part of a view matrix. Throws as frustumOf() does.
glm::dmat4 rigidView(const glm::dmat4& viewFromWorld);

/// Moves an orthographic camera back along its viewing direction until the whole box is in front of
/// it. Its picture stays the same, as it also shows what is behind the camera. Other cameras are
/// unchanged.
Frustum standingBack(Frustum frustum, const Box& box);

/// Transform from camera to clip space. Perspective: with the far plane at infinity, where a
/// direction's z equals its w bit for bit; `far` is ignored. Orthographic: depth is linear from
/// near to far.
glm::dmat4 clipFromView(const Frustum& frustum, double near,
                        double far = std::numeric_limits<double>::infinity());

/// Distance along the viewing direction.
double depthOf(const Frustum& frustum, const glm::dvec3& point);

/// The range of distances of the box, which must not be empty.
Interval depthsOf(const Frustum& frustum, const Box& box);

} // namespace edgeshade
