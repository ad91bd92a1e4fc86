#include "src/lab/compare.hpp"

#include "src/lab/heatmap.hpp"
#include "src/lab/lit_textures.hpp"
#include "src/lab/studio.hpp"
#include "src/lab/texture_alpha.hpp"
#include "src/shadow/geometry/kept_layers.hpp"
#include "src/shadow/geometry/light_budget.hpp"

#include <algorithm>
#include <map>
#include <memory>

namespace edgeshade::lab {
namespace {

/// Texels. Filtered maps, which know how steep what they show is, do with less.
std::vector<float> mapBiases(const ShadowMapSettings& map) {
    std::vector<float> biases = {0.5f, 1.0f, 1.5f, 2.0f, 3.0f, 4.0f, 6.0f};
    if (map.isFiltered()) biases.insert(biases.begin(), {0.0f, 0.25f});
    return biases;
}
constexpr std::size_t tuningViews = 3;

/// Lights from which the oracle's picture is drawn at once, and no more one for each set of lights
/// that some pixels have.
constexpr std::size_t manyLights = 9;

/// One view with its oracle, which all contenders share.
struct JudgedView {
    FrameRequest request;
    FrameView frame; ///< of the oracle's scene
    std::unique_ptr<Oracle> oracle;
    std::vector<Answer> answers;
};

/// `mostShadowed`: see chooseLights().
FrameView frameOf(const LoadedScene& loaded, const FrameRequest& request,
                  std::optional<std::size_t> mostShadowed = {}) {
    FrameView frame = makeFrameView(loaded.scene, request, worldBounds(loaded.scene));
    chooseLights(frame, mostShadowed);
    KeptLayers().fill(loaded.scene, loaded.settings.castMasked, frame.lights);
    frame.drawBlended = false;
    return frame;
}

JudgedView judge(const LoadedScene& loaded, const CompareTask& task, const LabView& view,
                 const AlphaLookup& alpha) {
    FrameRequest request;
    request.frustum = view.frustum;
    request.width = task.width;
    request.height = task.height;
    request.depth.near = task.near;
    request.lights = task.lights.empty() ? std::vector{view.light} : task.lights;
    JudgedView judged;
    judged.request = request;
    judged.frame = frameOf(loaded, request);
    judged.oracle = std::make_unique<Oracle>(
        Question{&loaded.scene, loaded.settings.castMasked, judged.frame.frustum,
                 judged.frame.near(), request.lights, task.width, task.height, loaded.cutoutsCast},
        alpha);
    judged.answers = traceAll(*judged.oracle, {});
    return judged;
}

/// Draws and judges contenders' pictures, view by view.
class Jury {
  public:
    Jury(const LoadedScene& loaded, const CompareTask& task)
        : loaded_(loaded), task_(task), studio_(task.width, task.height, task.limits),
          alpha_(textureAlpha(loaded)) {}

    /// Moves on to another view.
    void see(const LabView& view) {
        judged_ = judge(loaded_, task_, view, alpha_);
        pictures_ = {};
        unshadowed_.reset();
        frames_.clear();
        frames_.emplace(std::pair(&loaded_, std::optional<std::size_t>()), judged_.frame);
    }

    Comparison compare(Renderer& renderer, const Contender& contender) {
        drawUnshadowed(renderer.settings(), frameWith(loaded_, contender.depthSlices, {}));
        const LoadedScene& drawn = contender.scene ? *contender.scene : loaded_;
        FrameView frame =
            frameWith(drawn, contender.depthSlices, contender.settings.shadowedLights);
        pictures_.image = studio_.draw(renderer, drawn, frame);
        frame.mask = true;
        pictures_.mask = studio_.draw(renderer, drawn, frame);
        methods_ = studio_.methods();
        return compareWithOracle(*judged_.oracle, judged_.answers, pictures_,
                                 studio_.subpixelBits());
    }

    const std::vector<std::uint8_t>& image() const { return pictures_.image; }
    const Studio& studio() const { return studio_; }
    /// How the last contender's shadows were made, light by light.
    const std::vector<LightMethod>& methods() const { return methods_; }

  private:
    FrameView frameWith(const LoadedScene& drawn, std::optional<int> depthSlices,
                        std::optional<std::size_t> mostShadowed) {
        const auto key = std::pair(&drawn, mostShadowed);
        auto found = frames_.find(key);
        if (found == frames_.end())
            found = frames_.emplace(key, frameOf(drawn, judged_.request, mostShadowed)).first;
        FrameView frame = found->second;
        frame.divide(depthSlices);
        return frame;
    }

    /// The program's pictures without shadows. Contenders with the same slices and the same look
    /// share them.
    void drawUnshadowed(RenderSettings plain, const FrameView& frame) {
        const auto key =
            std::tuple(frame.slices.size(), plain.shading, plain.ambient, plain.exposure);
        if (unshadowed_ == key) return;
        unshadowed_ = key;
        plain.shadows = ShadowMethod::none;
        const auto renderer = std::make_shared<Renderer>(studio_.rendererFor(plain));
        pictures_.litAs = nullptr;
        if (frame.lights.size() >= manyLights)
            pictures_.litAs = [this, frame, renderer](const std::vector<Answer>& answers) {
                const LitTextures lit(answers, frame.lights.size(), frame.width, frame.height);
                return studio_.draw(*renderer, loaded_, frame, lit.lookups());
            };
        const auto drawn = std::make_shared<std::map<LightSet, std::vector<std::uint8_t>>>();
        pictures_.unshadowed = [this, frame, renderer, drawn](const LightSet& lights) {
            if (const auto found = drawn->find(lights); found != drawn->end()) return found->second;
            FrameView view = frame;
            for (std::size_t i = 0; i < view.lights.size(); ++i)
                view.lights[i].drawn = lights.has(i);
            auto picture = studio_.draw(*renderer, loaded_, view);
            constexpr std::size_t most = 16;
            if (drawn->size() < most) drawn->emplace(lights, picture);
            return picture;
        };
    }

    const LoadedScene& loaded_;
    const CompareTask& task_;
    Studio studio_;
    AlphaLookup alpha_;
    JudgedView judged_;
    /// Of judged_, by the scene and how many lights have shadows.
    std::map<std::pair<const LoadedScene*, std::optional<std::size_t>>, FrameView> frames_;
    Pictures pictures_;
    std::vector<LightMethod> methods_;
    /// What the pictures without shadows were drawn with: slices and look.
    std::optional<std::tuple<std::size_t, Shading, float, float>> unshadowed_;
};

/// The bias with the fewest wrong pixels over the first views.
float tunedBias(Jury& jury, const CompareTask& task, Renderer& renderer,
                const Contender& contender) {
    const std::vector<float> biases = mapBiases(contender.settings.map);
    std::vector<std::size_t> wrong(biases.size(), 0);
    for (std::size_t v = 0; v < std::min(tuningViews, task.views.size()); ++v) {
        jury.see(task.views[v]);
        for (std::size_t b = 0; b < biases.size(); ++b) {
            renderer.setMapBias(biases[b]);
            wrong[b] += jury.compare(renderer, contender).counts.wrongImagePixels;
        }
    }
    return biases[std::min_element(wrong.begin(), wrong.end()) - wrong.begin()];
}

} // namespace

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::vector<CompareResult>
compareAll(const LoadedScene& loaded, const CompareTask& task,
           const std::function<void(double, const std::string&)>& progress) {
    Jury jury(loaded, task);
    std::vector<CompareResult> results;
    std::vector<Renderer> renderers;
    for (const Contender& contender : task.contenders) {
        CompareResult& result = results.emplace_back();
        result.name = contender.name;
        result.settings = contender.settings;
        result.subpixelBits = jury.studio().subpixelBits();
        result.settings.layout = contender.layout.value_or(jury.studio().bestLayout());
        renderers.push_back(jury.studio().rendererFor(result.settings));
        if (contender.tuneMapBias) {
            progress(0.0, "tuning the bias of " + contender.name);
            result.settings.map.biasTexels = tunedBias(jury, task, renderers.back(), contender);
            renderers.back().setMapBias(result.settings.map.biasTexels);
        }
    }

    const double steps = static_cast<double>(task.views.size() * results.size());
    std::size_t done = 0;
    for (std::size_t v = 0; v < task.views.size(); ++v) {
        jury.see(task.views[v]);
        for (std::size_t c = 0; c < results.size(); ++c) {
            CompareResult& result = results[c];
            progress(static_cast<double>(done++) / steps,
                     "view " + task.views[v].name + ", " + result.name);
            const Comparison comparison = jury.compare(renderers[c], task.contenders[c]);
            const bool worst =
                result.views == 0 || comparison.counts.wrongImagePixels >
                                         result.byView[result.worstView].wrongImagePixels;
            if (worst) {
                result.worstView = v;
                result.heatmap = heatmap(jury.image(), comparison.kinds, task.width, task.height);
            }
            result.lights = jury.methods();
            result.counts += comparison.counts;
            result.byView.push_back(comparison.counts);
            ++result.views;
        }
    }
    progress(1.0, "done");
    return results;
}

} // namespace edgeshade::lab
