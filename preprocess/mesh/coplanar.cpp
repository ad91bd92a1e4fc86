#include "preprocess/mesh/coplanar.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace edgeshade {
namespace {

__extension__ using Wide = __int128;

/// Integers below this in magnitude: the determinant of three differences is a sum of six products
/// of three factors of at most 41 bits, which 127 bits hold.
constexpr double largestInteger = 0x1p40;

/// Four coordinates along one axis, times a power of two that makes all of them integers.
std::optional<std::array<std::int64_t, 4>> asIntegers(const std::array<float, 4>& values) {
    int lowest = 1000;
    for (const float value : values) {
        if (value == 0.0f) continue;
        int exponent = 0;
        const float mantissa = std::frexp(value, &exponent);
        const auto bits = static_cast<std::int32_t>(std::ldexp(mantissa, 24));
        lowest = std::min(lowest, exponent - 24 + __builtin_ctz(static_cast<unsigned>(bits)));
    }
    std::array<std::int64_t, 4> integers{};
    for (std::size_t i = 0; i < 4; ++i) {
        if (values[i] == 0.0f) continue;
        const double scaled = std::ldexp(static_cast<double>(values[i]), -lowest);
        if (!(std::abs(scaled) < largestInteger)) return std::nullopt;
        integers[i] = static_cast<std::int64_t>(scaled);
    }
    return integers;
}

/// Whether the determinant in double is farther from 0 than its rounding can have brought it.
bool isClearlyNotZero(const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w) {
    const glm::dvec3 cross = glm::cross(v, w);
    const glm::dvec3 size = glm::abs(u);
    const glm::dvec3 av = glm::abs(v), aw = glm::abs(w);
    const double magnitude = size.x * (av.y * aw.z + av.z * aw.y) +
                             size.y * (av.z * aw.x + av.x * aw.z) +
                             size.z * (av.x * aw.y + av.y * aw.x);
    return std::abs(glm::dot(u, cross)) > 1e-14 * magnitude;
}

} // namespace

bool areCoplanar(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    const glm::dvec3 origin(a);
    if (isClearlyNotZero(glm::dvec3(b) - origin, glm::dvec3(c) - origin, glm::dvec3(d) - origin))
        return false;
    std::array<std::array<Wide, 3>, 3> rows; // of b, c, d, relative to a
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const auto integers = asIntegers({a[axis], b[axis], c[axis], d[axis]});
        if (!integers) return false;
        for (std::size_t i = 0; i < 3; ++i)
            rows[i][static_cast<std::size_t>(axis)] = (*integers)[i + 1] - (*integers)[0];
    }
    const auto& [u, v, w] = rows;
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
               u[2] * (v[0] * w[1] - v[1] * w[0]) ==
           0;
}

} // namespace edgeshade
