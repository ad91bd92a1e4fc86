// Processor time of a step of a section plane that is dragged through a scene: cutting, records,
// and the tree of visible geometry. `section_times SCENE...` prints JSON.
#include "src/bench/statistics.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/shadow/view/scene_tree.hpp"
#include "tests/bench/told_scenes.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int steps = 40;

/// Milliseconds of processor time, of all threads.
double processorMs() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Json measured(const std::string& path) {
    Json json = {{"scene", std::filesystem::path(path).stem().string()}};
    for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
        LoadedScene loaded = loadScene(path, std::nullopt);
        const Box bounds = worldBounds(loaded.scene);
        SceneTree tree;
        std::vector<double> cutMs, treeMs, stepMs;
        for (int step = 0; step < steps; ++step) {
            const double share = 0.2 + 0.6 * step / steps;
            const double at = bounds.low.y + share * (bounds.high.y - bounds.low.y);
            const double before = processorMs();
            cutScene(loaded, {{{0.02, -1.0, 0.01, at}}, shadows, glm::vec3(0.5f)});
            const double cutAt = processorMs();
            cutMs.push_back(cutAt - before);
            tree.update(loaded.scene);
            const double treeAt = processorMs();
            treeMs.push_back(treeAt - cutAt);
            stepMs.push_back(treeAt - before);
        }
        const auto worst = [](const std::vector<double>& of) {
            return *std::max_element(of.begin() + 1, of.end()); // the first prepares
        };
        json[shadows == SectionShadows::cut ? "cut" : "whole"] = {
            {"first_ms", cutMs.front()},      {"cut_ms", bench::median(cutMs)},
            {"cut_ms_worst", worst(cutMs)},   {"tree_ms", bench::median(treeMs)},
            {"tree_ms_worst", worst(treeMs)}, {"step_ms", bench::median(stepMs)},
            {"first_tree_ms", treeMs.front()}};
    }
    return json;
}

} // namespace
} // namespace edgeshade

int main(int argc, char** argv) {
    return edgeshade::tellOfScenes(argc, argv, edgeshade::measured);
}
