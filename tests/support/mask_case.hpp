#pragma once

#include "tests/support/brute_force.hpp"
#include "tests/support/headless.hpp"

namespace edgeshade::test {

inline constexpr int maskWidth = 240, maskHeight = 180;

/// A lit mask to be drawn and held against ray casting.
struct Case {
    Scene scene;
    Camera camera;
    Light light;
    double near = 0.0; ///< 0: fitted
    bool castMasked = false;
    std::optional<int> slices{};      ///< nothing: as many as pay
    std::optional<Frustum> frustum{}; ///< in place of the camera's

    Frustum seen() const {
        return frustum.value_or(frustumOf(camera, static_cast<double>(maskWidth) / maskHeight));
    }
};

/// Pixels by what the mask shows, and by what rays say.
struct Outcome {
    int wrongBeyondOnePixel = 0;
    int wrong = 0;
    int lit = 0;
    int shadow = 0;
    std::string where; ///< the first of those beyond one pixel
};

/// Draws the mask. `nearDiscard`, `culledCaps`: see TestView.
Outcome run(const Case& test, RenderSettings settings = {}, bool nearDiscard = true,
            bool culledCaps = true);

/// Expects every pixel away from a boundary to be right, by every robust method and layout, by a
/// primitive map, and where visible points are asked one by one.
void expectRight(const Case& test);

/// The same by a primitive map; where some casters can't be in one, volumes are counted.
void expectLookedUpRight(const Case& test);

/// The same by an irregular z-buffer, where it is possible.
void expectRightByPoints(const Case& test);

/// The same by one method and every layout.
void expectRight(const Case& test, MultiplicityMethod method);

} // namespace edgeshade::test
