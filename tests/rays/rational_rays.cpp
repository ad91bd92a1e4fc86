#include "tests/rays/rational_rays.hpp"

#include "src/shadow/lights/light.hpp"
#include "src/shadow/lights/light_contact.hpp"

#include <boost/multiprecision/cpp_int.hpp>

namespace edgeshade::test {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;

Vector vectorOf(const glm::dvec3& v) {
    return {Rational(v.x), Rational(v.y), Rational(v.z)};
}
Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector along(const Vector& a, const Rational& t, const Vector& b) {
    return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
Rational dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector exactNormal(const rays::SurfaceTriangle& triangle) {
    const Vector a = vectorOf(triangle.a);
    return cross(minus(vectorOf(triangle.b), a), minus(vectorOf(triangle.c), a));
}

Vector placeOf(const std::vector<rays::SurfaceTriangle>& triangles,
               const rays::SurfacePoint& point) {
    const Vector origin = vectorOf(point.origin);
    if (point.triangle == rays::SurfacePoint::none) return origin;
    const Vector normal = exactNormal(triangles[point.triangle]);
    const Vector direction = vectorOf(point.direction);
    const Rational slope = dot(normal, direction);
    if (slope == 0) return origin;
    const Rational t = dot(normal, minus(vectorOf(triangles[point.triangle].a), origin)) / slope;
    return along(origin, t, direction);
}

/// Whether a ray meets the triangle at t > 0, its edges included (Moeller and Trumbore 1997).
bool meets(const rays::SurfaceTriangle& triangle, const Vector& origin, const Vector& direction) {
    const Vector a = vectorOf(triangle.a), ab = minus(vectorOf(triangle.b), a),
                 ac = minus(vectorOf(triangle.c), a);
    const Vector p = cross(direction, ac);
    const Rational determinant = dot(ab, p);
    if (determinant == 0) return false;
    const Vector s = minus(origin, a);
    const Rational u = dot(s, p) / determinant;
    if (u < 0 || u > 1) return false;
    const Vector q = cross(s, ab);
    const Rational v = dot(direction, q) / determinant;
    return v >= 0 && u + v <= 1 && dot(ac, q) / determinant > 0;
}

} // namespace

bool isLitRationally(const Scene& scene, const std::vector<rays::SurfaceTriangle>& triangles,
                     const rays::SurfacePoint& point, const glm::dvec3& direction) {
    const Vector towards = vectorOf(direction), sight = vectorOf(point.direction);
    const bool isFree = point.triangle == rays::SurfacePoint::none;
    if (isFree) {
        if (point.direction != glm::dvec3(0.0) && dot(sight, towards) >= 0) return false;
    } else {
        const rays::SurfaceTriangle& surface = triangles[point.triangle];
        const Vector normal = exactNormal(surface);
        if (surface.casts && dot(normal, sight).sign() * dot(normal, towards).sign() > 0)
            return false;
        const Batch& batch = scene.batches[surface.batch];
        const Light light{glm::dvec4(direction, 0.0)};
        if (contactOf(cornersInBatch(surface), placeInObject(light, batch.worldFromBatch)).grazes)
            return false;
    }
    const Vector place = placeOf(triangles, point);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (i != point.triangle && triangles[i].casts && meets(triangles[i], place, towards))
            return false;
    return true;
}

glm::dvec3 placeRationally(const std::vector<rays::SurfaceTriangle>& triangles,
                           const rays::SurfacePoint& point) {
    const Vector place = placeOf(triangles, point);
    return {place[0].convert_to<double>(), place[1].convert_to<double>(),
            place[2].convert_to<double>()};
}

} // namespace edgeshade::test
