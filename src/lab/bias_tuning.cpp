#include "src/lab/bias_tuning.hpp"

#include "src/rivals/maps/map_filters.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::lab {
namespace {

/// Biases to try, in texels. Filtered maps know the slope of their surfaces, and need less.
std::vector<float> mapBiases(const ShadowMapSettings& map) {
    std::vector<float> biases = {0.5f, 1.0f, 1.5f, 2.0f, 3.0f, 4.0f, 6.0f};
    if (isFiltered(map)) biases.insert(biases.begin(), {0.0f, 0.25f});
    return biases;
}
constexpr std::size_t tuningViews = 3;
constexpr double tuningPixels = 480.0 * 270.0; // of a small picture, at most

/// A bias, and the wrong pixels with it so far.
struct Trial {
    float bias = 0.0f;
    std::size_t wrong = 0;
};

} // namespace

/// Returns the bias with the fewest wrong pixels over the first views.
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

void tuneBiases(Jury& jury, const CompareTask& task, std::vector<Tuned>& contenders,
                const std::function<bool()>& goesOn) {
    std::vector<std::vector<Trial>> trials;
    for (const Tuned& one : contenders) {
        std::vector<Trial>& own = trials.emplace_back();
        for (const float bias : mapBiases(one.contender->settings.map))
            own.push_back({bias, 0});
    }
    const double pixels = static_cast<double>(task.width) * task.height;
    const double shrink = std::min(1.0, std::sqrt(tuningPixels / pixels));
    const auto small = [&](int size) { return std::max(1, static_cast<int>(shrink * size)); };
    const std::size_t views = contenders.empty() ? 0 : std::min(tuningViews, task.views.size());
    for (std::size_t v = 0; v < views; ++v) {
        if (v > 0 && !goesOn()) break;
        jury.see(task.views[v], small(task.width), small(task.height));
        for (std::size_t c = 0; c < contenders.size(); ++c) {
            for (Trial& trial : trials[c]) {
                contenders[c].renderer->setMapBias(trial.bias);
                trial.wrong +=
                    jury.countWrongImage(*contenders[c].renderer, *contenders[c].contender)
                        .wrongImagePixels;
            }
            std::ranges::stable_sort(trials[c], {}, &Trial::wrong);
            trials[c].resize((trials[c].size() + 1) / 2);
        }
    }
    for (std::size_t c = 0; c < contenders.size(); ++c) {
        contenders[c].bias = trials[c].front().bias;
        contenders[c].renderer->setMapBias(contenders[c].bias);
    }
}

} // namespace edgeshade::lab
