// Processor time for a frame before anything is drawn, over bench's flight: finding the visible
// geometry and, for a moving light, bounding the layers around it, by silhouettes and by triangles
// in turn. Needs no GL. `plan_times SCENE...` prints JSON.
#include "preprocess/base/stopwatch.hpp"
#include "src/bench/flythrough.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/layers/layer_search.hpp"
#include "src/shadow/view/frame_view.hpp"
#include "tests/bench/told_scenes.hpp"

#include <ctime>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frames = 24, turns = 8;
constexpr double aspect = 16.0 / 9.0;

/// Milliseconds of some calls: elapsed, and of all cores.
class Times {
  public:
    template <class Work>
    void add(const Work& work) {
        const std::clock_t start = std::clock();
        Stopwatch watch;
        work();
        seconds_ += watch.lap();
        processor_ += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        ++calls_;
    }
    /// A call's mean, as a list of {"ms", "processor_ms"}.
    Json mean() const {
        return {{"ms", 1e3 * seconds_ / calls_}, {"processor_ms", 1e3 * processor_ / calls_}};
    }

  private:
    double seconds_ = 0.0, processor_ = 0.0;
    int calls_ = 0;
};

/// Time to find the visible geometry of a frame by the scene's tree, the mean over a flight.
Json viewTimes(const Scene& scene, const Box& bounds, const Light& light) {
    const bench::Flythrough flight(bounds, 50.0, aspect);
    const SceneTree tree(scene);
    Times times;
    for (int frame = 0; frame < frames; ++frame) {
        FrameRequest request;
        request.frustum = frustumOf(flight.cameraAt(static_cast<double>(frame) / frames), aspect);
        request.width = 1920;
        request.height = 1080;
        request.lights = {light};
        times.add([&] { makeFrameView(scene, request, bounds, tree); });
    }
    return times.mean();
}

/// Times of bounding the layers around a light that is elsewhere each time, and the largest bounds
/// found.
class LayerTimes {
  public:
    template <class Bound>
    void add(const Bound& bound) {
        LayerBound found;
        times_.add([&] { found = bound(); });
        most_ = std::max(most_, found.most);
        groups_ = std::max(groups_, found.groupCount);
    }
    Json json() const {
        Json told = times_.mean();
        told["most"] = most_;
        told["groups"] = groups_;
        return told;
    }

  private:
    Times times_;
    std::size_t most_ = 0, groups_ = 0;
};

/// Adds to `told` the times for a light: of the first search, of later ones, and by triangles.
void addLayers(const LoadedScene& loaded, const Box& bounds, const std::string& name,
               const Light& light, Json& told) {
    LayerSearch search;
    LayerTimes first, later, byTriangles;
    const LayerCasters casters = loaded.layerCasters();
    first.add([&] { return search.bound(casters, light, stencilLimit); });
    for (int turn = 0; turn < turns; ++turn) {
        const double step = 0.003 * turn * (light.position.w != 0.0 ? bounds.diagonal() : 1.0);
        const Light moved = light.at(light.position + glm::dvec4(step, 0.0, -step, 0.0));
        later.add([&] { return search.bound(casters, moved, stencilLimit); });
        byTriangles.add([&] {
            return boundByTriangles(loaded.scene, casters.castMasked, std::span(&moved, 1),
                                    stencilLimit);
        });
    }
    told["first"][name] = first.json();
    told["layers"][name] = later.json();
    told["by_triangles"][name] = byTriangles.json();
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
        addLayers(loaded, bounds, name, light, told);
    return told;
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
