// posing_times SCENE [ANIMATION]: cost of a frame with a new pose, stage by stage on the processor
// and as a whole in a viewer, with volumes and with a shadow map that is redrawn. Prints JSON;
// milliseconds, medians over all frames.
#include "src/gl/headless_context.hpp"
#include "src/scene/pose.hpp"
#include "src/shadow/layers/layer_search.hpp"
#include "src/shadow/silhouette/silhouette_list.hpp"
#include "src/viewer/viewer.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "preprocess/reading/animation_reading.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>

using namespace edgeshade;
using Json = nlohmann::ordered_json;

namespace {

constexpr int frames = 60;
constexpr double framesPerSecond = 30.0;
const glm::dvec4 sun(0.6, 1.0, 0.35, 0.0);

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Times of stages by name, in order of first appearance.
struct Stages {
    std::vector<std::pair<std::string, std::vector<double>>> all;

    void add(const std::string& name, double seconds) {
        auto found = std::find_if(all.begin(), all.end(),
                                  [&](const auto& stage) { return stage.first == name; });
        if (found == all.end()) found = all.insert(all.end(), {name, {}});
        found->second.push_back(1e3 * seconds);
    }
    Json json() const {
        Json medians;
        for (const auto& [name, values] : all)
            medians[name] = median(values);
        return medians;
    }
};

/// Posing and the stages that depend on it, without a GL.
Json stagesOf(LoadedScene loaded, const Animation& animation) {
    Stages stages;
    LayerSearch layers;
    for (int frame = 0; frame < frames; ++frame) {
        const double seconds = std::fmod(frame / framesPerSecond, animation.duration);
        Stopwatch watch;
        const std::vector<Placed> placed =
            place(loaded.scene, poseAt(animation, loaded.scene, seconds));
        stages.add("pose_ms", watch.lap());
        for (std::size_t b = 0; b < placed.size(); ++b)
            if (placed[b].reshaped)
                loaded.planePairs[b] = std::make_shared<const PlanePairShadow>(
                    posedPlanePairs(*loaded.planePairs[b], loaded.scene.batches[b]));
        stages.add("refresh_ms", watch.lap());
        for (std::size_t b = 0; b < placed.size(); ++b) {
            if (!placed[b].reshaped) continue;
            const PlanePairShadow& shadow = *loaded.planePairs[b];
            const glm::vec4 light(glm::inverse(loaded.scene.batches[b].worldFromBatch) * sun);
            LightTrack track;
            track.follow(light);
            SilhouetteList list;
            ListMemory memory;
            listSilhouettes(shadow, LightFacings(shadow), track.ball(), 23, list,
                            std::numeric_limits<double>::infinity(), memory);
        }
        stages.add("silhouettes_ms", watch.lap());
        layers.bound(loaded.layerCasters(), Light{sun}, stencilLimit);
        stages.add("layers_ms", watch.lap());
    }
    return stages.json();
}

/// Whole frames of a viewer: with a new pose each, and with the same pose.
Json framesOf(const LoadedScene& loaded, const gl::HeadlessContext& context, std::size_t animation,
              const Json& side) {
    viewer::Viewer viewer(context.capabilities());
    viewer.resize(960, 540, 1.0);
    viewer.show(loaded);
    viewer.change({{"show_lights", false},
                   {"shading", "base"},
                   {"ground", "off"},
                   {"animation", animation},
                   {"left", side},
                   {"lights", {{sun.x, sun.y, sun.z, sun.w}}}});
    static_cast<void>(viewer.stats()); // from now on frames are timed until they are finished
    Stages stages;
    double now = 0.0;
    for (int frame = 0; frame < frames; ++frame) {
        Stopwatch watch;
        viewer.change({{"time", std::fmod(frame / framesPerSecond, viewer.animationSeconds())}});
        viewer.frame(now += 0.1);
        stages.add("moving_ms", watch.lap());
    }
    for (int frame = 0; frame < frames; ++frame) {
        viewer.invalidate();
        Stopwatch watch;
        viewer.frame(now); // the light never comes to rest
        stages.add("still_ms", watch.lap());
    }
    const viewer::FrameStats stats = viewer.stats();
    Json json = stages.json();
    json["pose_and_upload_ms"] = stats.poseMs;
    json["plan_ms"] = stats.planMs;
    return json;
}

} // namespace

int main(int count, char** words) {
    if (count != 2 && count != 3) {
        std::cerr << "posing_times SCENE [ANIMATION]\n";
        return 2;
    }
    const LoadedScene loaded = loadScene(words[1], std::nullopt);
    const std::vector<AnimationTitle> titles = animationTitles(*loaded.document);
    const AnimationTitle* const title = count == 3       ? findAnimation(titles, words[2])
                                        : titles.empty() ? nullptr
                                                         : &titles.front();
    Warnings warnings;
    const auto animation =
        title ? readAnimation(*loaded.document, warnings, title->index) : std::nullopt;
    if (!animation) {
        std::cerr << "There is no such animation.\n";
        return 2;
    }
    std::size_t deforming = 0;
    for (const Batch& batch : loaded.scene.batches)
        if (batch.deforms()) deforming += batch.geometry->indices.size() / 3;
    Json told = {{"triangles", loaded.scene.triangleCount()},
                 {"deforming_triangles", deforming},
                 {"animation", title->name},
                 {"stages", stagesOf(loaded, *animation)}};
    const gl::HeadlessContext context({960, 540, 0, gl::Limits::device});
    const auto index = static_cast<std::size_t>(title - titles.data());
    told["volumes"] = framesOf(loaded, context, index, {{"shadows", "volumes"}});
    for (const int size : {1024, 2048})
        told["map " + std::to_string(size)] =
            framesOf(loaded, context, index, {{"shadows", "map"}, {"map_size", size}});
    std::cout << told.dump(1) << std::endl;
}
