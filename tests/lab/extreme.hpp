#pragma once

#include "src/lab/oracle.hpp"
#include "src/scene/load.hpp"
#include "tests/support/headless.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::test {

/// One case of the table of extremes: a scene drawn in code, its view, and the difficulty it
/// provokes.
struct Extreme {
    std::string name;
    std::string provokes;
    std::function<LoadedScene()> load; ///< called only when the case runs
    Camera camera{{5, 4, 6}, {0, 0.5, 0}, 50.0};
    std::optional<Frustum> frustum{}; ///< in place of the camera's
    std::vector<Light> lights = {pointLight({0.6, 5, 0.3})};
    int width = 320;
    int height = 240;
    DepthChoice depth{};            ///< empty: near plane and slices are fitted
    int depthBits = 24;             ///< of the depth buffer
    std::size_t leastTriangles = 0; ///< that the scene must have
    double mostWrongPercent = 0.5;  ///< of the visible pixels, including boundaries and ties
    bool takesLong = false;         ///< over 20 s

    /// The frustum in use.
    Frustum seen() const {
        return frustum.value_or(frustumOf(camera, static_cast<double>(width) / height));
    }
};

/// The themes of the table.
std::vector<Extreme> placeExtremes();  ///< scales, distant origins, nodes that distort
std::vector<Extreme> lightExtremes();  ///< positions and numbers of lights
std::vector<Extreme> viewExtremes();   ///< eyes, near planes, pictures, depth buffers
std::vector<Extreme> shapeExtremes();  ///< single surfaces: slivers, fans, seams, self-intersection
std::vector<Extreme> amountExtremes(); ///< from empty to millions of triangles, layers, holes

} // namespace edgeshade::test
