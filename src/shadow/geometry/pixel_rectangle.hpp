#pragma once

#include <algorithm>

namespace edgeshade {

/// A rectangle of pixels, in GL's coordinates from the lower left.
struct PixelRectangle {
    int x = 0, y = 0;
    int width = 0, height = 0;

    bool operator==(const PixelRectangle&) const = default;
    bool empty() const { return width <= 0 || height <= 0; }
};

/// The intersection of both; may be empty.
inline PixelRectangle intersection(const PixelRectangle& a, const PixelRectangle& b) {
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::max(0, std::min(a.x + a.width, b.x + b.width) - x),
            std::max(0, std::min(a.y + a.height, b.y + b.height) - y)};
}

/// The smallest rectangle around both.
inline PixelRectangle united(const PixelRectangle& a, const PixelRectangle& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
    return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
            std::max(a.y + a.height, b.y + b.height) - y};
}

} // namespace edgeshade
