#pragma once

#include "src/lab/oracle.hpp"
#include "src/scene/load.hpp"
#include "tests/support/headless.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::test {

/// One case of the table of extremes: a scene drawn in code, how it is seen, and what it provokes.
struct Extreme {
    std::string name;
    std::string provokes;
    std::function<LoadedScene()> load; ///< drawn only when the case runs
    Camera camera{{5, 4, 6}, {0, 0.5, 0}, 50.0};
    std::optional<Frustum> frustum{}; ///< in place of the camera's
    std::vector<Light> lights = {pointLight({0.6, 5, 0.3})};
    int width = 320;
    int height = 240;
    DepthChoice depth{};            ///< nothing: near plane and slices are fitted
    int depthBits = 24;             ///< of the depth buffer
    std::size_t leastTriangles = 0; ///< the scene must have
    double mostWrongPercent = 0.5;  ///< of the visible pixels, boundaries and ties included
    bool takesLong = false;         ///< over 20 s

    /// What is seen.
    Frustum seen() const {
        return frustum.value_or(frustumOf(camera, static_cast<double>(width) / height));
    }
};

/// The themes of the table.
std::vector<Extreme> placeExtremes();  ///< scales, far-off origins, nodes that distort
std::vector<Extreme> lightExtremes();  ///< where lights stand, and how many
std::vector<Extreme> viewExtremes();   ///< eyes, near planes, pictures, depth buffers
std::vector<Extreme> shapeExtremes();  ///< single surfaces: slivers, fans, seams, self-intersection
std::vector<Extreme> amountExtremes(); ///< nothing at all to millions, layers, holes

} // namespace edgeshade::test
