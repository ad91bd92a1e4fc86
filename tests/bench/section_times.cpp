// Processor time of a step of a section plane that is dragged through a scene: cutting, records,
// and the tree of visible geometry. `section_times SCENE...` prints JSON.
#include "preprocess/base/stopwatch.hpp"
#include "src/bench/statistics.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/shadow/view/scene_tree.hpp"
#include "tests/bench/told_scenes.hpp"

#include <algorithm>
#include <filesystem>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int steps = 40;

Json measured(const std::string& path) {
    Json json = {{"scene", std::filesystem::path(path).stem().string()}};
    for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
        LoadedScene loaded = loadScene(path, std::nullopt);
        const Box bounds = worldBounds(loaded.scene);
        SceneTree tree;
        std::vector<double> cutMs, treeMs;
        for (int step = 0; step < steps; ++step) {
            const double share = 0.2 + 0.6 * step / steps;
            const double at = bounds.low.y + share * (bounds.high.y - bounds.low.y);
            Stopwatch watch;
            cutScene(loaded, {{{0.02, -1.0, 0.01, at}}, shadows, glm::vec3(0.5f)});
            cutMs.push_back(1e3 * watch.lap());
            tree.update(loaded.scene);
            treeMs.push_back(1e3 * watch.lap());
        }
        const auto worst = [](const std::vector<double>& of) {
            return *std::max_element(of.begin() + 1, of.end()); // the first prepares
        };
        json[shadows == SectionShadows::cut ? "cut" : "whole"] = {
            {"first_ms", cutMs.front()},
            {"cut_ms", bench::median(cutMs)},
            {"cut_ms_worst", worst(cutMs)},
            {"tree_ms", bench::median(treeMs)}};
    }
    return json;
}

} // namespace
} // namespace edgeshade

int main(int argc, char** argv) {
    return edgeshade::tellOfScenes(argc, argv, edgeshade::measured);
}
