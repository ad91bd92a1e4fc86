#include "src/lab/compare_counts.hpp"

#include "src/lab/compared_frame.hpp"
#include "src/lab/studio.hpp"
#include "src/lab/texture_alpha.hpp"
#include "src/render/frame/prepare_scene.hpp"

#include <algorithm>

namespace edgeshade::lab {
namespace {

LitCounts drawn(Studio& studio, Renderer& renderer, const LoadedScene& loaded,
                const FrameView& frame, std::vector<LightMethod>& lights) {
    GpuScene& scene = studio.sceneFor(loaded, renderer.settings().records());
    LitCounter counter(studio.capabilities());
    counter.begin(frame.width, frame.height);
    prepareScene(scene, loaded, frame, renderer);
    counter.addPoints(renderer, scene, loaded, frame, 0, 0, frame.lights.front().points.size());
    gl::requireNoError("drawing for comparison");
    lights = lightMethods(scene, frame, renderer);
    return counter.read();
}

/// A soft map's mask as counts of `points` points: the lit share of them.
LitCounts shares(Studio& studio, Renderer& renderer, const LoadedScene& loaded, FrameView frame,
                 std::size_t points) {
    frame.mask = true;
    const std::vector<std::uint8_t> mask = studio.draw(renderer, loaded, frame);
    LitCounts counts{frame.width, frame.height, static_cast<std::uint32_t>(points), 1, {}, {}};
    for (std::size_t i = 0; i < mask.size(); i += 4) {
        counts.lit.push_back(static_cast<std::uint16_t>((2 * points * mask[i] + 255) / 510));
        counts.surface.push_back(mask[i + 3] != 0);
    }
    return counts;
}

} // namespace

std::vector<CountResult>
compareCounts(const LoadedScene& loaded, const CompareTask& task,
              const std::function<void(double, const std::string&)>& progress) {
    Studio studio(task.width, task.height, task.limits);
    const AlphaLookup alpha = textureAlpha(loaded);
    std::vector<CountResult> results;
    std::size_t most = 1;
    for (const Contender& contender : task.contenders) {
        CountResult& result = results.emplace_back();
        result.name = contender.name;
        result.settings = contender.settings;
        result.settings.layout = contender.layout.value_or(studio.bestLayout());
        most = std::max(most, result.settings.lightSamples);
    }
    const double steps = static_cast<double>(task.views.size() * (results.size() + 1));
    std::size_t done = 0;
    for (const LabView& view : task.views) {
        FrameRequest request;
        request.frustum = view.frustum;
        request.width = task.width;
        request.height = task.height;
        request.depth.near = task.near;
        request.lights = {task.lights.empty() ? view.light : task.lights.front()};
        request.lightSamples = most;
        progress(static_cast<double>(done++) / steps, "view " + view.name + ", oracle");
        const FrameView judged = comparedFrame(loaded, request);
        PointOracle oracle({&loaded.scene, loaded.settings.castMasked, judged.frustum,
                            judged.near(), lightPoints(request.lights.front(), most), task.width,
                            task.height, loaded.cutoutsCast},
                           alpha);
        for (std::size_t c = 0; c < results.size(); ++c) {
            CountResult& result = results[c];
            progress(static_cast<double>(done++) / steps, "view " + view.name + ", " + result.name);
            const Contender& contender = task.contenders[c];
            request.lightSamples = result.settings.countedPoints();
            const std::size_t points = result.settings.lightSamples;
            Renderer renderer = studio.rendererFor(result.settings);
            const LoadedScene& scene = contender.scene ? *contender.scene : loaded;
            FrameView frame = comparedFrame(scene, request);
            frame.divide(contender.depthSlices);
            const LitCounts counts = request.lightSamples > 0
                                         ? drawn(studio, renderer, scene, frame, result.lights)
                                         : shares(studio, renderer, scene, frame, points);
            result.byView.push_back(oracle.compare(counts, points));
            result.sums += result.byView.back();
        }
    }
    progress(1.0, "done");
    return results;
}

} // namespace edgeshade::lab
