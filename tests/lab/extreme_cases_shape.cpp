#include "tests/lab/extreme.hpp"
#include "tests/lab/extreme_scenes.hpp"

namespace edgeshade::test {
namespace {

Extreme drawn(const std::string& name, const std::string& provokes,
              const std::function<SceneBuilder()>& draw) {
    return {.name = name, .provokes = provokes, .load = later(draw)};
}

Extreme sliverOf(const std::string& name, float aspect) {
    return drawn("sliver " + name, "thin triangles", [aspect] { return sliver(aspect); });
}

Extreme fanOf(int n, const std::string& provokes) {
    return drawn("n = " + std::to_string(n), provokes, [n] { return fan(n); });
}

SceneBuilder crossingBoxes() {
    return SceneBuilder()
        .floor(6)
        .box({-1, 0.5f, -1}, {0.6f, 2, 0.6f})
        .box({-0.3f, 1, -0.3f}, {1.2f, 2.4f, 1.2f});
}

SceneBuilder coincidentSheets() {
    return SceneBuilder()
        .floor(6)
        .quad({-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1})
        .quad({-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1});
}

SceneBuilder overlappingSheets() {
    return SceneBuilder()
        .floor(6)
        .quad({-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1})
        .quad({-0.3f, 1, 0.2f}, {-0.1f, 1, -1.4f}, {1.6f, 1, -0.9f}, {1.3f, 1, 0.4f});
}

SceneBuilder boxOnTheFloor() {
    return SceneBuilder().floor(6).box({-1, 0, -1}, {1, 1.5f, 1});
}

} // namespace

std::vector<Extreme> shapeExtremes() {
    return {
        sliverOf("1e3", 1e3f),
        sliverOf("1e5", 1e5f),
        sliverOf("1e7", 1e7f),
        drawn("degenerate triangles", "records of no area", boxWithDegenerateTriangles),
        drawn("duplicates, same winding", "n = 3 at every edge", [] { return duplicated(false); }),
        drawn("duplicates, opposite winding", "n = 3, one cancels",
              [] { return duplicated(true); }),
        fanOf(3, "a fin"),
        fanOf(7, "an edge split into records"),
        fanOf(64, "an edge split into records"),
        fanOf(128, "an edge split into records"),
        drawn("T-junction", "cracks", tJunction),
        drawn("Moebius strip", "no orientation", moebiusStrip),
        drawn("Klein bottle", "no orientation, closed, crosses itself", kleinBottle),
        drawn("open hemisphere", "open edges, both sides", hemisphere),
        drawn("boxes through each other", "self-intersection", crossingBoxes),
        drawn("coincident sheets", "equal depths", coincidentSheets),
        drawn("coplanar sheets overlap", "equal depths, other edges", overlappingSheets),
        drawn("caster on its receiver", "contact", boxOnTheFloor),
    };
}

} // namespace edgeshade::test
