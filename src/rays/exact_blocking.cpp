#include "src/rays/exact_blocking.hpp"

#include "src/rays/exact_vector.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace edgeshade::rays {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Vector = ExactVector<Integer>;

/// The power of two of which doubles become multiples.
class Grid {
  public:
    void add(const glm::dvec3& v) {
        for (const double value : {v.x, v.y, v.z})
            if (value != 0.0) exponent_ = std::min(exponent_, std::ilogb(value) - (digits - 1));
    }
    void add(const Corners& corners) {
        for (const glm::dvec3& corner : corners)
            add(corner);
    }
    Integer of(double value) const {
        if (value == 0.0) return 0;
        const int exponent = std::ilogb(value) - (digits - 1);
        const auto mantissa = static_cast<long long>(std::scalbn(value, -exponent));
        return Integer(mantissa) << static_cast<unsigned>(exponent - exponent_);
    }
    Vector of(const glm::dvec3& v) const { return {of(v.x), of(v.y), of(v.z)}; }
    /// The double nearest to a multiple of the grid divided by a number that is not 0.
    double rounded(const Integer& numerator, const Integer& denominator) const {
        const boost::multiprecision::cpp_rational ratio(numerator, denominator);
        return std::scalbn(ratio.convert_to<double>(), exponent_);
    }

  private:
    static constexpr int digits = std::numeric_limits<double>::digits;
    int exponent_ = std::numeric_limits<int>::max();
};

/// A vector's direction: only its ratios count.
Vector directionOf(const glm::dvec3& v) {
    Grid grid;
    grid.add(v);
    return grid.of(v);
}

/// A triangle on a grid.
struct ExactTriangle {
    Vector a, b, c;

    ExactTriangle(const Corners& corners, const Grid& grid)
        : a(grid.of(corners[0])), b(grid.of(corners[1])), c(grid.of(corners[2])) {}

    Vector normal() const { return cross(b - a, c - a); }
};

/// A point as multiples of a grid, divided by w > 0.
struct ExactPoint {
    Vector xyz;
    Integer w = 1;

    ExactPoint(const SurfacePoint& point, const ExactTriangle* own, const Grid& grid)
        : xyz(grid.of(point.origin)) {
        if (!own) return;
        const Vector direction = directionOf(point.direction), normal = own->normal();
        const Integer along = dot(normal, direction);
        if (along == 0) return;
        const Integer height = dot(normal, own->a - xyz);
        xyz = along * xyz + height * direction;
        w = along;
        if (w < 0) {
            w = -w;
            xyz = Integer(-1) * xyz;
        }
    }
};

} // namespace

bool blocksExactly(const SurfacePoint& point, const Corners* own, const Corners& other,
                   const glm::dvec4& light) {
    return blockingExactly(point, own, other, light) == Blocking::blocks;
}

Blocking blockingExactly(const SurfacePoint& point, const Corners* own, const Corners& other,
                         const glm::dvec4& light) {
    Grid grid;
    grid.add(point.origin);
    grid.add(other);
    if (own) grid.add(*own);
    const bool isPoint = light.w != 0.0;
    if (isPoint) grid.add(glm::dvec3(light));

    const ExactTriangle triangle(other, grid);
    const std::optional<ExactTriangle> surface =
        own ? std::optional<ExactTriangle>(std::in_place, *own, grid) : std::nullopt;
    const ExactPoint from(point, surface ? &*surface : nullptr, grid);
    // For a point light w times the vector to it, so that the light is at t = w.
    const Vector towards =
        isPoint ? from.w * grid.of(glm::dvec3(light)) - from.xyz : directionOf(glm::dvec3(light));

    const Vector normal = triangle.normal();
    const Integer height = dot(normal, from.w * triangle.a - from.xyz); // w times
    if (height.sign() == 0) return Blocking::inPlane;
    const int facing = dot(normal, towards).sign();
    if (facing != height.sign()) return Blocking::misses;
    if (isPoint && abs(height) >= abs(dot(normal, towards))) return Blocking::misses;
    const auto isOutside = [&](const Vector& start, const Vector& end) {
        return dot(cross(end - start, towards), from.xyz - from.w * start).sign() * facing > 0;
    };
    const bool isMet = !isOutside(triangle.a, triangle.b) && !isOutside(triangle.b, triangle.c) &&
                       !isOutside(triangle.c, triangle.a);
    return isMet ? Blocking::blocks : Blocking::misses;
}

int sideExactly(const Corners& triangle, const glm::dvec3& direction) {
    Grid grid;
    grid.add(triangle);
    return dot(ExactTriangle(triangle, grid).normal(), directionOf(direction)).sign();
}

int dotSignExactly(const glm::dvec3& a, const glm::dvec3& b) {
    return dot(directionOf(a), directionOf(b)).sign();
}

glm::dvec3 placeExactly(const SurfacePoint& point, const Corners& own) {
    Grid grid;
    grid.add(point.origin);
    grid.add(own);
    const ExactTriangle surface(own, grid);
    const ExactPoint place(point, &surface, grid);
    return {grid.rounded(place.xyz.x, place.w), grid.rounded(place.xyz.y, place.w),
            grid.rounded(place.xyz.z, place.w)};
}

} // namespace edgeshade::rays
