#pragma once

#include "src/shadow/lights/light.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

/// How a spot's light falls off, as shaders_es2/light_window.glsl takes it. Where the angles are
/// the same the edge is a thousandth wide, of a narrow cone as of a wide one.
struct ConeWindow {
    float inverseOuter, scale;

    explicit ConeWindow(const Cone& cone) {
        const auto fromOne = [](double angle) { // 1 - cos(angle), which rounding leaves its digits
            const double half = std::sin(0.5 * angle);
            return 2.0 * half * half;
        };
        const double outer = fromOne(cone.outer), inner = fromOne(cone.inner);
        inverseOuter = static_cast<float>(1.0 / outer);
        scale = static_cast<float>(outer / std::max(outer - inner, 1e-3 * outer));
    }
};

} // namespace edgeshade
