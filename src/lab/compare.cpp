#include "src/lab/compare.hpp"

#include "src/gl/headless_context.hpp"
#include "src/lab/heatmap.hpp"
#include "src/lab/texture_alpha.hpp"

#include <array>
#include <map>

namespace edgeshade::lab {
namespace {

constexpr std::array<float, 7> mapBiases = {0.5f, 1.0f, 1.5f, 2.0f, 3.0f, 4.0f, 6.0f}; // texels
constexpr std::size_t tuningViews = 3;

/// The scene on the GPU, in one context, by layout.
class Studio {
  public:
    Studio(const LoadedScene& loaded, int width, int height)
        : loaded_(loaded), context_({width, height}) {}

    std::vector<std::uint8_t> draw(const RenderSettings& settings, const FrameView& view) {
        Renderer renderer(settings, context_.capabilities());
        const auto groups = settings.shadows == ShadowMethod::volumes
                                ? uploadNeededGroups(loaded_, view, settings.layout)
                                : std::vector<GroupedShadow>();
        renderer.draw(sceneFor(settings.layout), view, groups);
        gl::requireNoError("drawing for comparison");
        return context_.readPixels();
    }

    SidesLayout layoutFor(SidesLayout wanted) const {
        return context_.capabilities().instancing ? wanted : SidesLayout::notInstanced;
    }

  private:
    const GpuScene& sceneFor(SidesLayout layout) {
        auto found = scenes_.find(layout);
        if (found == scenes_.end())
            found = scenes_.emplace(layout, uploadScene(loaded_, layout, context_.capabilities()))
                        .first;
        return found->second;
    }

    const LoadedScene& loaded_;
    gl::HeadlessContext context_;
    std::map<SidesLayout, GpuScene> scenes_;
};

/// One view with its oracle, which all contenders share.
struct JudgedView {
    FrameView frame;
    std::unique_ptr<Oracle> oracle;
    std::vector<Answer> answers;
};

JudgedView judge(const LoadedScene& loaded, const CompareTask& task, const LabView& view,
                 const AlphaAt& alphaAt) {
    FrameRequest request;
    request.camera = view.camera;
    request.width = task.width;
    request.height = task.height;
    request.depth.near = task.near;
    request.lights = task.lights.empty() ? std::vector{view.light} : task.lights;
    JudgedView judged;
    judged.frame = makeFrameView(loaded, request);
    judged.frame.drawBlended = false;
    judged.oracle = std::make_unique<Oracle>(Question{&loaded.scene, loaded.settings.castMasked,
                                                      view.camera, judged.frame.near(),
                                                      judged.frame.lights, task.width, task.height},
                                             alphaAt);
    judged.answers = traceAll(*judged.oracle, {});
    return judged;
}

/// The program's pictures without shadows, which the oracle's picture is put together from.
void drawUnshadowed(Studio& studio, RenderSettings plain, FrameView frame, Pictures& pictures) {
    plain.shadows = ShadowMethod::none;
    frame.drawnLights = 0;
    pictures.ambient = studio.draw(plain, frame);
    pictures.unshadowed.clear();
    for (std::size_t i = 0; i < frame.lights.size(); ++i) {
        frame.drawnLights = 1u << i;
        pictures.unshadowed.push_back(studio.draw(plain, frame));
    }
}

Comparison compareOne(Studio& studio, const RenderSettings& settings,
                      std::optional<int> depthSlices, JudgedView& judged, Pictures& pictures) {
    FrameView frame = judged.frame;
    frame.slices = divideDepth(frame.near(), frame.farthestDepth, depthSlices);
    drawUnshadowed(studio, settings, frame, pictures);
    pictures.image = studio.draw(settings, frame);
    frame.mask = true;
    pictures.mask = studio.draw(settings, frame);
    return compareWithOracle(*judged.oracle, judged.answers, pictures);
}

/// The bias with the fewest wrong pixels over the first views.
float tunedBias(Studio& studio, const LoadedScene& loaded, const CompareTask& task,
                const Contender& contender, const AlphaAt& alphaAt) {
    RenderSettings settings = contender.settings;
    settings.layout = studio.layoutFor(settings.layout);
    std::array<std::size_t, mapBiases.size()> wrong{};
    for (std::size_t v = 0; v < std::min(tuningViews, task.views.size()); ++v) {
        JudgedView judged = judge(loaded, task, task.views[v], alphaAt);
        Pictures pictures;
        for (std::size_t b = 0; b < mapBiases.size(); ++b) {
            settings.map.biasTexels = mapBiases[b];
            wrong[b] += compareOne(studio, settings, contender.depthSlices, judged, pictures)
                            .counts.wrongImagePixels;
        }
    }
    return mapBiases[std::min_element(wrong.begin(), wrong.end()) - wrong.begin()];
}

} // namespace

std::vector<CompareResult>
compareAll(const LoadedScene& loaded, const CompareTask& task,
           const std::function<void(double, const std::string&)>& progress) {
    Studio studio(loaded, task.width, task.height);
    const AlphaAt alphaAt = textureAlpha(loaded);
    std::vector<CompareResult> results;
    for (const Contender& contender : task.contenders) {
        CompareResult& result = results.emplace_back();
        result.name = contender.name;
        result.settings = contender.settings;
        result.settings.layout = studio.layoutFor(contender.settings.layout);
        if (contender.tuneMapBias) {
            progress(0.0, "tuning the bias of " + contender.name);
            result.settings.map.biasTexels = tunedBias(studio, loaded, task, contender, alphaAt);
        }
    }

    const double steps = static_cast<double>(task.views.size() * results.size());
    std::size_t done = 0;
    for (std::size_t v = 0; v < task.views.size(); ++v) {
        JudgedView judged = judge(loaded, task, task.views[v], alphaAt);
        Pictures pictures;
        for (std::size_t c = 0; c < results.size(); ++c) {
            CompareResult& result = results[c];
            progress(static_cast<double>(done++) / steps,
                     "view " + task.views[v].name + ", " + result.name);
            const Comparison comparison = compareOne(
                studio, result.settings, task.contenders[c].depthSlices, judged, pictures);
            const bool worst =
                result.views == 0 || comparison.counts.wrongImagePixels >
                                         result.byView[result.worstView].wrongImagePixels;
            if (worst) {
                result.worstView = v;
                result.heatmap = heatmap(pictures.image, comparison.kinds, task.width, task.height);
            }
            result.counts += comparison.counts;
            result.byView.push_back(comparison.counts);
            ++result.views;
        }
    }
    progress(1.0, "done");
    return results;
}

} // namespace edgeshade::lab
