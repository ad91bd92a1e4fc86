#include "src/lab/compare.hpp"

#include "src/lab/bias_tuning.hpp"
#include "src/lab/heatmap.hpp"

namespace edgeshade::lab {

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
