// Processor time for a frame before anything is drawn, over bench's flight: finding the visible
// geometry and, for a moving light, bounding the layers around it. Needs no GL. `plan_times
// SCENE...` prints JSON.
#include "preprocess/base/stopwatch.hpp"
#include "src/bench/flythrough.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/layers/layer_bound.hpp"
#include "src/shadow/view/frame_view.hpp"
#include "tests/bench/told_scenes.hpp"

#include <ctime>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frames = 24, turns = 8;
constexpr double aspect = 16.0 / 9.0;

/// Milliseconds since its start: elapsed, and of all cores, each a list of `times`.
class Times {
  public:
    Json per(int times) {
        const double processor = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
        return {{"ms", 1e3 * watch_.lap() / times}, {"processor_ms", 1e3 * processor / times}};
    }

  private:
    Stopwatch watch_;
    std::clock_t start_ = std::clock();
};

/// Time to find the visible geometry of a frame, the mean over a flight.
Json viewTimes(const Scene& scene, const Box& bounds, const Light& light) {
    const bench::Flythrough flight(bounds, 50.0, aspect);
    Times times;
    for (int frame = 0; frame < frames; ++frame) {
        FrameRequest request;
        request.frustum = frustumOf(flight.cameraAt(static_cast<double>(frame) / frames), aspect);
        request.width = 1920;
        request.height = 1080;
        request.lights = {light};
        makeFrameView(scene, request, bounds);
    }
    return times.per(frames);
}

/// The same for bounding the layers around a light that is elsewhere each time, and the largest
/// bound found.
Json layersOf(const Scene& scene, const Box& bounds, const Light& light) {
    LayerBound bound;
    std::size_t most = 0, groups = 0;
    Times times;
    for (int turn = 0; turn < turns; ++turn) {
        const double step = 0.003 * turn * (light.position.w != 0.0 ? bounds.diagonal() : 1.0);
        bound =
            boundLayers(scene, false, light.at(light.position + glm::dvec4(step, 0.0, -step, 0.0)),
                        stencilLimit);
        most = std::max(most, bound.most);
        groups = std::max(groups, bound.groupCount);
    }
    Json told = times.per(turns);
    told["most"] = most;
    told["groups"] = groups;
    return told;
}

Json measured(const std::string& path) {
    LoadedScene loaded = loadScene(path, std::nullopt);
    loaded.scene.culls = false;
    const Box bounds = worldBounds(loaded.scene);
    const glm::dvec3 at = besideAndAbove(bounds);
    const std::pair<const char*, Light> lights[] = {
        {"sun", {{0.4, 1, 0.3, 0}}},
        {"low sun", {{-0.9, 0.25, 0.35, 0}}},
        {"lamp", {glm::dvec4(at, 1.0)}},
        {"lamp inside", {glm::dvec4(bounds.center() + 0.05 * bounds.diagonal(), 1.0)}}};
    Json told = {{"scene", std::filesystem::path(path).stem().string()},
                 {"triangles", loaded.scene.triangleCount()},
                 {"view", viewTimes(loaded.scene, bounds, lights[0].second)}};
    for (const auto& [name, light] : lights)
        told["layers"][name] = layersOf(loaded.scene, bounds, light);
    return told;
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
