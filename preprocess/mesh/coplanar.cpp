#include "preprocess/mesh/coplanar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace edgeshade {
namespace {

__extension__ using Wide = __int128;

/// Coordinates as integers of this many bits and a sign. The determinant of three differences is a
/// sum of six products of three factors of at most 41 bits, which 127 bits hold.
constexpr int integerBits = 40;

/// A coordinate as an odd integer times a power of two; 0 is 0.
struct Scaled {
    std::int64_t odd = 0;
    int exponent = 0;
};

Scaled scaled(float value) {
    const std::uint32_t bits = glm::floatBitsToUint(value);
    const std::uint32_t fraction = bits & 0x7FFFFFu;
    const auto field = static_cast<int>(bits >> 23 & 0xFFu); // 0: denormal
    const std::uint32_t mantissa = field != 0 ? fraction | 0x800000u : fraction;
    if (mantissa == 0) return {};
    const int zeros = __builtin_ctz(mantissa);
    const auto odd = static_cast<std::int64_t>(mantissa >> zeros);
    return {bits >> 31 ? -odd : odd, std::max(field, 1) - 150 + zeros};
}

/// Four coordinates along one axis, scaled by a common power of two to integers.
std::optional<std::array<std::int64_t, 4>> asIntegers(const std::array<float, 4>& values) {
    std::array<Scaled, 4> parts;
    int lowest = 1000;
    for (std::size_t i = 0; i < 4; ++i) {
        parts[i] = scaled(values[i]);
        if (parts[i].odd != 0) lowest = std::min(lowest, parts[i].exponent);
    }
    std::array<std::int64_t, 4> integers{};
    for (std::size_t i = 0; i < 4; ++i) {
        if (parts[i].odd == 0) continue;
        const int shift = parts[i].exponent - lowest;
        if (shift >= integerBits) return std::nullopt;
        integers[i] = parts[i].odd * (std::int64_t{1} << shift);
        if (std::abs(integers[i]) >> integerBits != 0) return std::nullopt;
    }
    return integers;
}

/// Whether the determinant in double precision differs from 0 by more than its rounding error.
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
    std::array<std::array<Wide, 3>, 3> rows; // b, c, d, relative to a
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
