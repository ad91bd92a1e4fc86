#pragma once

#include "tests/support/brute_force.hpp"
#include "tests/support/headless.hpp"

namespace edgeshade::test {

inline constexpr int maskWidth = 240, maskHeight = 180;

/// A lit mask to draw and compare with ray casting.
struct Case {
    Scene scene;
    Camera camera;
    Light light;
    double near = 0.0; ///< 0: fitted
    bool castMasked = false;
    std::optional<int> slices{};      ///< empty: as many as pay
    std::optional<Frustum> frustum{}; ///< in place of the camera's

    Frustum seen() const {
        return frustum.value_or(frustumOf(camera, static_cast<double>(maskWidth) / maskHeight));
    }
};

/// Counts of pixels by the mask's answer and the rays' answer.
struct Outcome {
    int wrongBeyondOnePixel = 0;
    int wrong = 0;
    int lit = 0;
    int shadow = 0;
    std::string where; ///< the first pixel that is wrong beyond one pixel
};

/// Draws the mask. `nearDiscard`, `culledCaps`: see TestView.
Outcome run(const Case& test, RenderSettings settings = {}, bool nearDiscard = true,
            bool culledCaps = true);

/// Expects every pixel away from a boundary to be right, by every robust method and layout, by a
/// primitive map, and with visible points tested one by one.
void expectRight(const Case& test);

/// The same with a primitive map; if some casters can't be in one, volumes are counted.
void expectLookedUpRight(const Case& test);

/// The same with one method and every layout.
void expectRight(const Case& test, MultiplicityMethod method);

} // namespace edgeshade::test
