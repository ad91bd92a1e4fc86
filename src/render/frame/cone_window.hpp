#pragma once

#include "src/shadow/lights/light.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade {

/// How a spot's light falls off, in the form of shaders_es2/light_window.glsl. If its two angles
/// are equal, the edge is a thousandth of 1 - cos(outer) wide, for narrow and wide cones alike.
struct ConeWindow {
    float inverseOuter, scale;

    explicit ConeWindow(const Cone& cone) {
        const auto fromOne = [](double angle) { // 1 - cos(angle) without cancellation
            const double half = std::sin(0.5 * angle);
            return 2.0 * half * half;
        };
        const double outer = fromOne(cone.outer), inner = fromOne(cone.inner);
        inverseOuter = static_cast<float>(1.0 / outer);
        scale = static_cast<float>(outer / std::max(outer - inner, 1e-3 * outer));
    }
};

} // namespace edgeshade
