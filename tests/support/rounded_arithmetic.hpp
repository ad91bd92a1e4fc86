#pragma once

// The shaders' own source for signs (see shader_arithmetic.hpp) in the floats of a poorer device,
// with what GLSL ES 1.00 guarantees for highp: 16 mantissa bits and magnitudes from 2^-62 to 2^62
// (section 4.5.2). Every constant, input and result is rounded.

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "shaders_es2/record_layout.glsl"

namespace edgeshade::rounded_arithmetic {

/// The device's rounding, which GLSL ES 1.00 leaves open.
enum class Rounding { nearest, towardsZero, down };

/// A number with 16 mantissa bits. Small ones become 0, large ones infinite. Sums and products are
/// computed in double, which holds both exactly or nearly so, then rounded.
template <Rounding rounding>
class Number {
  public:
    Number() = default;
    Number(double value) : value_(rounded(value)) {} // NOLINT: implicit, like GLSL's literals

    double value() const { return value_; }

    friend Number operator+(Number x, Number y) { return x.value_ + y.value_; }
    friend Number operator-(Number x, Number y) { return x.value_ - y.value_; }
    friend Number operator*(Number x, Number y) { return x.value_ * y.value_; }
    friend Number operator-(Number x) { return -x.value_; }
    friend bool operator==(Number x, Number y) { return x.value_ == y.value_; }
    friend bool operator<(Number x, Number y) { return x.value_ < y.value_; }

  private:
    static constexpr int dropped = 52 - 16; // of a double's mantissa

    static double rounded(double value) {
        if (value == 0.0 || !std::isfinite(value)) return value;
        auto bits = std::bit_cast<std::uint64_t>(value);
        const std::uint64_t unit = std::uint64_t{1} << dropped, rest = bits & (unit - 1);
        bits -= rest;
        const bool odd = (bits & unit) != 0;
        const bool away = rounding == Rounding::nearest
                              ? rest > unit / 2 || (rest == unit / 2 && odd)
                              : rounding == Rounding::down && rest != 0 && value < 0.0;
        if (away) bits += unit;
        const double result = std::bit_cast<double>(bits);
        if (std::abs(result) < 0x1p-62) return 0.0;
        return std::abs(result) >= 0x1p62 ? std::copysign(INFINITY, result) : result;
    }

    double value_ = 0.0;
};

template <Rounding rounding>
struct Shaders {
    using Scalar = Number<rounding>;
    struct vec2 {
        Scalar x, y;
    };
    struct vec3 {
        vec3() = default;
        vec3(Scalar x_, Scalar y_, Scalar z_) : x(x_), y(y_), z(z_) {}
        explicit vec3(const glm::vec3& v) : x(v.x), y(v.y), z(v.z) {}
        friend vec3 operator-(const vec3& a, const vec3& b) {
            return {a.x - b.x, a.y - b.y, a.z - b.z};
        }
        Scalar x, y, z;
    };
    struct vec4 {
        explicit vec4(const glm::vec4& v) : x(v.x), y(v.y), z(v.z), w(v.w) {}
        vec4(const glm::vec3& v, double w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
        Scalar x, y, z, w;
    };
    static Scalar sign(Scalar x) { return x < 0.0 ? -1.0 : Scalar(0.0) < x ? 1.0 : 0.0; }
    static Scalar clamp(Scalar x, Scalar low, Scalar high) {
        return x < low ? low : high < x ? high : x;
    }

    // GLSL's float is the poorer one.
#define float Scalar
#include "tests/support/shader_methods.inc"
#undef float
};

} // namespace edgeshade::rounded_arithmetic
