#pragma once

#include "src/shadow/geometry/interval.hpp"
#include "src/shadow/view/camera.hpp"

#include <limits>
#include <optional>

namespace edgeshade {

/// What a picture shows: a camera of any place and turn, and the window that it looks through,
/// anywhere across its viewing direction. Where the depth range begins and ends is not part of it.
struct Frustum {
    glm::dmat4 viewFromWorld{1.0}; ///< rigid: x right, y up, looking along -z
    /// The window's lower left and upper right corner: x and y a unit of depth; of an orthographic
    /// picture, x and y at any depth. high > low.
    glm::dvec2 low{-1.0}, high{1.0};
    bool orthographic = false;

    bool operator==(const Frustum&) const = default;
    glm::dvec2 size() const { return high - low; }
    /// x and y of a picture point, (-1, -1) to (1, 1): a unit of depth, or at any depth.
    glm::dvec2 windowAt(const glm::dvec2& point) const {
        return 0.5 * (low + high) + 0.5 * point * size();
    }
    glm::dvec3 position() const; ///< in the world
    glm::dvec3 forward() const;  ///< the viewing direction in the world, of length 1
    /// Where all rays of the picture come from, in the world: the position, or, at infinity (w =
    /// 0), the direction against the viewing direction.
    glm::dvec4 eye() const;
};

/// The camera's, of a picture with this aspect (width over height). With a height an orthographic
/// picture that many scene units high, whatever the camera's field of view.
Frustum frustumOf(const Camera& camera, double aspect, std::optional<double> height = {});

/// Another engine's: its view matrix and its projection, perspective (off-axis, too) or
/// orthographic, to clip space as GL has it. What the projection says of depth is not used. Scales
/// of the view that are the same in all directions are taken out. Throws Error(usage) that says
/// what is wrong with a matrix: numbers that aren't finite, a view that shears or mirrors, a
/// projection that is neither.
Frustum frustumOf(const glm::dmat4& viewFromWorld, const glm::dmat4& clipFromView);

/// The rigid part of a view matrix, as above.
glm::dmat4 rigidView(const glm::dmat4& viewFromWorld);

/// Moves an orthographic camera back along its viewing direction until all of the box is before it.
/// Its picture shows what is behind the camera as well, so it stays the same. Others stay as they
/// are.
Frustum standingBack(Frustum frustum, const Box& box);

/// Camera to clip space. Perspective: with the far plane at infinity, where a direction's z equals
/// its w bit for bit; `far` is not asked. Orthographic: depth is linear from near to far.
glm::dmat4 clipFromView(const Frustum& frustum, double near,
                        double far = std::numeric_limits<double>::infinity());

/// Distance along the viewing direction.
double depthOf(const Frustum& frustum, const glm::dvec3& point);

/// The distances that the box spans, which must not be empty.
Interval depthsOf(const Frustum& frustum, const Box& box);

} // namespace edgeshade
