#pragma once

#include <type_traits>

namespace edgeshade::rays {

/// A vector of numbers without rounding, such as Boost's integers and rationals.
template <class Number>
struct ExactVector {
    Number x, y, z;
};

template <class Number>
ExactVector<Number> operator+(const ExactVector<Number>& a, const ExactVector<Number>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
ExactVector<Number> operator-(const ExactVector<Number>& a, const ExactVector<Number>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
ExactVector<Number> operator*(const std::type_identity_t<Number>& s, const ExactVector<Number>& v) {
    return {s * v.x, s * v.y, s * v.z};
}

template <class Number>
Number dot(const ExactVector<Number>& a, const ExactVector<Number>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
ExactVector<Number> cross(const ExactVector<Number>& a, const ExactVector<Number>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace edgeshade::rays
