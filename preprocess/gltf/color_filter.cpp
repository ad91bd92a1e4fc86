#include "preprocess/gltf/color_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace edgeshade {
namespace {

/// Decodes one colour with components of type T (KHR_meshopt_compression, "Filter 4: color").
template <class T>
void decodeColor(std::uint8_t* at) {
    T components[4];
    std::memcpy(components, at, sizeof components);
    using Signed = std::make_signed_t<T>;
    const int y = components[0], co = static_cast<Signed>(components[1]),
              cg = static_cast<Signed>(components[2]);
    // Alpha's highest set bit gives the number of bits of all components; the bits below it are
    // alpha.
    const int bits = std::max(static_cast<int>(std::bit_width(components[3])), 1);
    const int largest = (1 << bits) - 1;
    const int alpha = components[3] & (largest >> 1);
    constexpr int full = std::numeric_limits<T>::max();
    const auto scaled = [&](int value) {
        const double share = static_cast<double>(std::clamp(value, 0, largest)) / largest;
        return static_cast<T>(std::lround(share * full));
    };
    components[0] = scaled(y + co - cg);
    components[1] = scaled(y + cg);
    components[2] = scaled(y - co - cg);
    components[3] = scaled(alpha << 1 | (alpha & 1));
    std::memcpy(at, components, sizeof components);
}

} // namespace

void decodeColorFilter(std::span<std::uint8_t> colors, std::size_t stride) {
    for (std::size_t i = 0; i + stride <= colors.size(); i += stride)
        if (stride == 8)
            decodeColor<std::uint16_t>(&colors[i]);
        else
            decodeColor<std::uint8_t>(&colors[i]);
}

} // namespace edgeshade
