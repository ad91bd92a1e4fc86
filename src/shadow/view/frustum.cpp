#include "src/shadow/view/frustum.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/base/vectors.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <string>

namespace edgeshade {
namespace {

/// Relative tolerance for matrices, which may come from floats.
constexpr double tolerance = 1e-4;

[[noreturn]] void fail(const std::string& what) {
    throw Error(ExitStatus::usage, what);
}

void requireFinite(const glm::dmat4& matrix, const std::string& name) {
    if (!isFinite(matrix)) fail("The " + name + " matrix has a number that is not finite.");
}

/// The scale factor of a view matrix, even if it mirrors.
double scaleOf(const glm::dmat4& viewFromWorld) {
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(viewFromWorld))));
}

bool isNear(const glm::dvec4& value, const glm::dvec4& wanted) {
    return glm::length(value - wanted) <= tolerance;
}

} // namespace

glm::dvec3 Frustum::position() const {
    return -(glm::transpose(glm::dmat3(viewFromWorld)) * glm::dvec3(viewFromWorld[3]));
}

glm::dvec3 Frustum::forward() const {
    return -glm::dvec3(glm::row(viewFromWorld, 2));
}

glm::dvec4 Frustum::eye() const {
    return orthographic ? glm::dvec4(-forward(), 0.0) : glm::dvec4(position(), 1.0);
}

Frustum frustumOf(const Camera& camera, double aspect, std::optional<double> height) {
    const double up = height ? 0.5 * *height : tangentOfHalfFov(camera.fovDegrees);
    const glm::dvec2 half(up * aspect, up);
    return {viewFromWorld(camera), -half, half, height.has_value()};
}

glm::dmat4 rigidView(const glm::dmat4& viewFromWorld) {
    requireFinite(viewFromWorld, "camera's");
    if (!isNear(glm::row(viewFromWorld, 3), {0, 0, 0, 1}))
        fail("The camera's matrix is not a view matrix: its last row, the numbers 4, 8, 12 and 16, "
             "is not 0, 0, 0, 1.");
    const glm::dmat3 turn(viewFromWorld);
    const double scale = scaleOf(viewFromWorld);
    if (!(scale > 0.0)) fail("The camera's matrix is singular.");
    if (glm::determinant(turn) < 0.0) fail("The camera's matrix mirrors the world.");
    // Gram-Schmidt removes rounding errors; larger ones mean that it is no rotation.
    const glm::dvec3 right = glm::row(turn, 0) / scale, up = glm::row(turn, 1) / scale;
    const glm::dvec3 backward = glm::row(turn, 2) / scale;
    const glm::dvec3 z = glm::normalize(backward);
    const glm::dvec3 y = glm::normalize(up - glm::dot(up, z) * z);
    const glm::dvec3 x = glm::cross(y, z);
    if (glm::distance(x, right) > tolerance || glm::distance(y, up) > tolerance ||
        glm::distance(z, backward) > tolerance)
        fail("The camera's matrix is not a rotation and translation: it shears or scales.");
    glm::dmat4 rigid(1.0);
    for (glm::length_t c = 0; c < 3; ++c)
        rigid[c] = {x[c], y[c], z[c], 0.0};
    rigid[3] = glm::dvec4(glm::dvec3(viewFromWorld[3]) / scale, 1.0);
    return rigid;
}

Frustum frustumOf(const glm::dmat4& viewFromWorld, const glm::dmat4& clipFromView) {
    requireFinite(clipFromView, "projection");
    Frustum frustum;
    frustum.viewFromWorld = rigidView(viewFromWorld);
    // w is -z in perspective, or constant; either may be scaled.
    const glm::dvec4 w = glm::row(clipFromView, 3);
    const double unit = std::max(std::abs(w.z), std::abs(w.w));
    const glm::dvec4 share = w / unit;
    frustum.orthographic = isNear(share, {0, 0, 0, 1});
    if (!frustum.orthographic && !isNear(share, {0, 0, -1, 0}))
        fail("The projection is neither perspective nor orthographic: its last row is not (0, 0, "
             "-1, 0), nor (0, 0, 0, 1).");
    // The camera's scale affects values in scene units.
    const double scale = scaleOf(viewFromWorld);
    for (glm::length_t axis = 0; axis < 2; ++axis) {
        const glm::dvec4 row = glm::row(clipFromView, axis) / unit;
        const double slope = row[axis];
        glm::dvec4 wanted(0.0);
        wanted[axis] = slope;
        wanted[frustum.orthographic ? 3 : 2] = row[frustum.orthographic ? 3 : 2];
        if (!(slope > 0.0) || glm::length(row - wanted) > tolerance * slope)
            fail("The projection rotates, mirrors or shears the picture.");
        // -1 = slope x + offset at the window's low end, with x at depth 1.
        const double offset = frustum.orthographic ? row.w : -row.z;
        const double perUnit = frustum.orthographic ? scale : 1.0;
        frustum.low[axis] = (-1.0 - offset) / slope / perUnit;
        frustum.high[axis] = (1.0 - offset) / slope / perUnit;
    }
    return frustum;
}

Frustum standingBack(Frustum frustum, const Box& box) {
    if (!frustum.orthographic || box.empty()) return frustum;
    const double nearest = depthsOf(frustum, box).low;
    const double wanted = 0.1 * std::max(box.diagonal(), glm::length(frustum.size()));
    if (nearest < wanted) frustum.viewFromWorld[3].z -= wanted - nearest;
    return frustum;
}

glm::dmat4 clipFromView(const Frustum& frustum, double near, double far) {
    const glm::dvec2 size = frustum.size(), sum = frustum.low + frustum.high;
    glm::dmat4 clip(0.0);
    clip[0][0] = 2.0 / size.x;
    clip[1][1] = 2.0 / size.y;
    if (frustum.orthographic) {
        clip[3][0] = -sum.x / size.x;
        clip[3][1] = -sum.y / size.y;
        clip[2][2] = -2.0 / (far - near);
        clip[3][2] = -(far + near) / (far - near);
        clip[3][3] = 1.0;
        return clip;
    }
    clip[2][0] = sum.x / size.x;
    clip[2][1] = sum.y / size.y;
    clip[2][2] = -1.0;
    clip[2][3] = -1.0;
    clip[3][2] = -2.0 * near;
    return clip;
}

double depthOf(const Frustum& frustum, const glm::dvec3& point) {
    return -(frustum.viewFromWorld * glm::dvec4(point, 1.0)).z;
}

Interval depthsOf(const Frustum& frustum, const Box& box) {
    Interval depths;
    for (int corner = 0; corner < 8; ++corner)
        depths.add(depthOf(frustum, box.corner(corner)));
    return depths;
}

} // namespace edgeshade
