#include "src/lab/exact_judge.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>

namespace edgeshade::lab {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// A vector of rationals.
struct Vector {
    Rational x, y, z;

    Vector() = default;
    explicit Vector(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
    Vector(Rational px, Rational py, Rational pz)
        : x(std::move(px)), y(std::move(py)), z(std::move(pz)) {}
};

Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vector operator*(const Rational& s, const Vector& v) {
    return {s * v.x, s * v.y, s * v.z};
}

Rational dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct ExactTriangle {
    Vector a, b, c, normal;

    explicit ExactTriangle(const SurfaceTriangle& t) : a(t.a), b(t.b), c(t.c) {
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

bool isCoplanar(const ExactTriangle& surface, const ExactTriangle& other) {
    return dot(surface.normal, other.a - surface.a) == 0 &&
           dot(surface.normal, other.b - surface.a) == 0 &&
           dot(surface.normal, other.c - surface.a) == 0;
}

int signOf(const Rational& value) {
    return value.sign();
}

/// Whether anything but the surface itself is between the point and the light.
bool isBlocked(const Oracle& oracle, std::uint32_t own, const ExactTriangle& surface,
               const Vector& point, const glm::dvec3& roundedPoint, std::size_t lightIndex) {
    const glm::dvec4 light = oracle.lightFromEye(lightIndex);
    const Rational w(light.w);
    const Vector towards = Vector(glm::dvec3(light)) - w * point;
    const glm::dvec3 roundedTowards = glm::dvec3(light) - roundedPoint * light.w;
    for (const std::uint32_t j : oracle.candidates(roundedPoint, roundedTowards, light.w != 0.0)) {
        if (j == own || !oracle.blocks(j, lightIndex)) continue;
        const ExactTriangle other(oracle.triangles()[j]);
        const auto hit = intersect(other, point, towards);
        if (!hit || hit->t <= 0 || (light.w != 0.0 && hit->t >= 1)) continue;
        if (!isCoplanar(surface, other)) return true;
    }
    return false;
}

/// Whether a point is within the cone; `fromLight`: its position relative to the light. The angle's
/// tangent is rounded.
bool isInCone(const Cone& cone, const Vector& fromLight) {
    const Vector axis(cone.axis);
    const Rational along = dot(axis, fromLight), slope(std::tan(cone.outer));
    const Vector aside = cross(axis, fromLight);
    return along > 0 && dot(aside, aside) < slope * slope * along * along;
}

} // namespace

Verdict judgeExactly(const Oracle& oracle, double x, double y) {
    const Question& question = oracle.question();
    const PixelRay ray = pixelRay(question, x, y);
    const Vector direction(ray.direction), origin(ray.origin);
    const Rational near(question.near);
    Verdict verdict;
    std::optional<ExactHit> nearest;
    std::uint32_t own = 0;
    for (const std::uint32_t i : oracle.candidates(ray.origin, ray.direction, false)) {
        const SurfaceTriangle& triangle = oracle.triangles()[i];
        if (!triangle.visible) continue;
        const auto hit = intersect(ExactTriangle(triangle), origin, direction);
        if (!hit || hit->t < near || hit->t <= 0 || oracle.isCutOut(triangle, hit->u, hit->v))
            continue;
        if (nearest && hit->t == nearest->t) verdict.coincident = true;
        if (nearest && hit->t >= nearest->t) continue;
        verdict.coincident = false;
        nearest = hit;
        own = i;
    }
    if (!nearest) return verdict;

    const ExactTriangle surface(oracle.triangles()[own]);
    const Vector point = origin + nearest->t * direction;
    const glm::dvec3 roundedPoint = ray.at(nearest->t.convert_to<double>());
    const glm::dvec4& eye = oracle.eye();
    const int eyeSide =
        signOf(dot(surface.normal, Vector(glm::dvec3(eye)) - Rational(eye.w) * surface.a));
    verdict.answer.surface = true;
    for (std::size_t i = 0; i < question.lights.size(); ++i) {
        const glm::dvec4 light = oracle.lightFromEye(i);
        const int lightSide =
            signOf(dot(surface.normal, Vector(glm::dvec3(light)) - Rational(light.w) * surface.a));
        if (const double range = oracle.rangeOf(i); std::isfinite(range)) {
            const Vector towards = Vector(glm::dvec3(light)) - Rational(light.w) * point;
            if (dot(towards, towards) >= Rational(range) * Rational(range)) continue;
        }
        if (const Cone* cone = oracle.coneOf(i))
            if (!isInCone(*cone, point - Vector(glm::dvec3(light)))) continue;
        if (lightSide == 0) verdict.coincident = true;
        const bool turnedAway = oracle.triangles()[own].casts && eyeSide * lightSide < 0;
        if (!turnedAway && !oracle.isGrazed(own, i) &&
            !isBlocked(oracle, own, surface, point, roundedPoint, i))
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
