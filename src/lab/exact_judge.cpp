#include "src/lab/exact_judge.hpp"

#include "src/rays/exact_blocking.hpp"
#include "src/rays/exact_vector.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>

namespace edgeshade::lab {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = rays::ExactVector<Rational>;

Vector exactly(const glm::dvec3& v) {
    return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

struct ExactTriangle {
    Vector a, b, c, normal;

    explicit ExactTriangle(const SurfaceTriangle& t)
        : a(exactly(t.a)), b(exactly(t.b)), c(exactly(t.c)) {
        normal = cross(b - a, c - a);
    }
};

struct ExactHit {
    Rational t;
    double u, v; ///< rounded, as only textures use them
};

/// The intersection of origin + t * direction with the triangle, boundary included.
std::optional<ExactHit> intersect(const ExactTriangle& triangle, const Vector& origin,
                                  const Vector& direction) {
    const Vector ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const Vector p = cross(direction, ac);
    const Rational determinant = dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const Vector s = origin - triangle.a;
    const Rational u = dot(s, p) / determinant;
    if (u < 0 || u > 1) return std::nullopt;
    const Vector q = cross(s, ab);
    const Rational v = dot(direction, q) / determinant;
    if (v < 0 || u + v > 1) return std::nullopt;
    return ExactHit{dot(ac, q) / determinant, u.convert_to<double>(), v.convert_to<double>()};
}

int signOf(const Rational& value) {
    return value.sign();
}

/// Whether a caster blocks the light of a point on a triangle.
bool isBlocked(const Oracle& oracle, const rays::SurfacePoint& point, std::size_t lightIndex) {
    const auto cornersOf = [&](std::uint32_t i) {
        const SurfaceTriangle& triangle = oracle.triangles()[i];
        return rays::Corners{triangle.a, triangle.b, triangle.c};
    };
    const rays::Corners surface = cornersOf(point.triangle);
    const glm::dvec3 place = rays::placeExactly(point, surface);
    const glm::dvec4 light = oracle.lightFromEye(lightIndex);
    const glm::dvec3 towards = glm::dvec3(light) - place * light.w;
    for (const std::uint32_t i : oracle.candidates(place, towards, light.w != 0.0)) {
        if (i == point.triangle || !oracle.blocks(i, lightIndex)) continue;
        if (rays::blocksExactly(point, &surface, cornersOf(i), light) &&
            !oracle.isHoleAt(i, place, towards))
            return true;
    }
    return false;
}

/// Whether a point is within the cone; `fromLight`: its position relative to the light. The angle's
/// tangent is rounded.
bool isInCone(const Cone& cone, const Vector& fromLight) {
    const Vector axis = exactly(cone.axis);
    const Rational along = dot(axis, fromLight), slope(std::tan(cone.outer));
    const Vector aside = cross(axis, fromLight);
    return along > 0 && dot(aside, aside) < slope * slope * along * along;
}

} // namespace

std::optional<ExactSurface> surfaceExactly(const Oracle& oracle, double x, double y) {
    const PixelRay ray = pixelRay(oracle.question(), x, y);
    const Vector direction = exactly(ray.direction), origin = exactly(ray.origin);
    const Rational near(oracle.question().near);
    std::optional<ExactHit> nearest;
    ExactSurface surface;
    // The first of coinciding surfaces is drawn.
    for (const std::uint32_t i : oracle.firstCandidates(x, y)) {
        const SurfaceTriangle& triangle = oracle.triangles()[i];
        const auto hit = intersect(ExactTriangle(triangle), origin, direction);
        if (!hit || hit->t < near || hit->t <= 0 || oracle.isCutOut(triangle, hit->u, hit->v))
            continue;
        if (nearest && hit->t == nearest->t) surface.coincident = true;
        if (nearest && hit->t >= nearest->t) continue;
        surface = {i, hit->t.convert_to<double>(), false};
        nearest = hit;
    }
    if (!nearest) return std::nullopt;
    return surface;
}

Verdict judgeExactly(const Oracle& oracle, double x, double y) {
    const Question& question = oracle.question();
    Verdict verdict;
    const std::optional<ExactSurface> seen = surfaceExactly(oracle, x, y);
    if (!seen) return verdict;
    verdict.coincident = seen->coincident;

    const PixelRay ray = pixelRay(question, x, y);
    const std::uint32_t own = seen->triangle;
    const ExactTriangle surface(oracle.triangles()[own]);
    const rays::SurfacePoint lineOfSight{ray.origin, ray.direction, own};
    const Vector origin = exactly(ray.origin), direction = exactly(ray.direction);
    const Vector point = origin + dot(surface.normal, surface.a - origin) /
                                      dot(surface.normal, direction) * direction;
    const int eyeSide = -signOf(dot(surface.normal, direction));
    verdict.answer.surface = true;
    for (std::size_t i = 0; i < question.lights.size(); ++i) {
        const glm::dvec4 light = oracle.lightFromEye(i);
        const int lightSide =
            signOf(dot(surface.normal, exactly(glm::dvec3(light)) - Rational(light.w) * surface.a));
        if (const double range = oracle.rangeOf(i); std::isfinite(range)) {
            const Vector towards = exactly(glm::dvec3(light)) - Rational(light.w) * point;
            if (dot(towards, towards) >= Rational(range) * Rational(range)) continue;
        }
        if (const Cone* cone = oracle.coneOf(i))
            if (!isInCone(*cone, point - exactly(glm::dvec3(light)))) continue;
        if (lightSide == 0) verdict.coincident = true;
        const bool turnedAway = oracle.triangles()[own].casts && eyeSide * lightSide < 0;
        if (!turnedAway && !oracle.isGrazed(own, i) && !isBlocked(oracle, lineOfSight, i))
            verdict.answer.lit.add(i);
    }
    return verdict;
}

Verdict judge(const Oracle& oracle, std::size_t pixel) {
    const glm::dvec2 center = centerOf(oracle.question(), pixel);
    const Oracle::Checked checked = oracle.checkedAt(center.x, center.y);
    return checked.certain ? Verdict{checked.answer} : judgeExactly(oracle, center.x, center.y);
}

} // namespace edgeshade::lab
