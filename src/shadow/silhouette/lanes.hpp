#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace edgeshade::silhouette {

// The compiler's vector types: SSE, NEON or WebAssembly's SIMD from one source.
inline constexpr std::size_t lanes = 4;
using Floats = float __attribute__((vector_size(lanes * sizeof(float))));
using Ints = std::int32_t __attribute__((vector_size(lanes * sizeof(std::int32_t))));

inline Floats load(const std::vector<float>& values, std::size_t at) {
    Floats result;
    std::memcpy(&result, values.data() + at, sizeof(result));
    return result;
}

inline Floats all(float value) {
    return Floats{value, value, value, value};
}

inline Ints all(std::int32_t value) {
    return Ints{value, value, value, value};
}

inline Floats magnitude(Floats value) {
    const Ints withoutSign = {0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF, 0x7FFFFFFF};
    Ints bits;
    std::memcpy(&bits, &value, sizeof(bits));
    bits &= withoutSign;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
}

/// Lane by lane; the second where the first is no number.
inline Floats lesser(Floats a, Floats b) {
    return a < b ? a : b;
}
inline Floats greater(Floats a, Floats b) {
    return a > b ? a : b;
}

} // namespace edgeshade::silhouette
