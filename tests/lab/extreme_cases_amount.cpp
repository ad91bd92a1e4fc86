#include "tests/lab/extreme.hpp"
#include "tests/lab/extreme_scenes.hpp"

namespace edgeshade::test {
namespace {

Extreme sheets(int count) {
    return {.name = std::to_string(count) + " sheets",
            .provokes = "an 8-bit stencil's count",
            .load = later([count] { return stack(count); }),
            .lights = {pointLight({0.6, 7, 0.3})}};
}

Extreme leaves(const std::string& name, LoadedScene (*load)()) {
    return {.name = name, .provokes = "casters with holes", .load = load};
}

SceneBuilder oneTriangle() {
    return SceneBuilder().triangle({-2, 0, 0}, {2, 0, 0}, {0, 2, 0});
}

} // namespace

std::vector<Extreme> amountExtremes() {
    return {
        {.name = "nothing at all", .provokes = "empty buffers", .load = later([] {
                                                                    return SceneBuilder();
                                                                })},
        {.name = "one triangle", .provokes = "hardly anything", .load = later(oneTriangle)},
        sheets(255),
        sheets(256),
        sheets(257),
        sheets(1000),
        leaves("masked leaves, texture", leavesByTexture),
        leaves("masked leaves, vertex alpha", leavesByVertexAlpha),
        {.name = "5 million triangles",
         .provokes = "sizes of buffers",
         .load = [] { return hills(1582); },
         .camera = {{6, 5, 7}, {0, 0, 0}, 50.0},
         .lights = {sun({0.8, 0.5, 0.3})},
         .leastTriangles = 5'000'000,
         .takesLong = true},
    };
}

} // namespace edgeshade::test
