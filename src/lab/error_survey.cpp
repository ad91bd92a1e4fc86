#include "src/lab/error_survey.hpp"

namespace edgeshade::lab {

ErrorSurvey::ErrorSurvey(const LoadedScene& loaded, const CompareTask& task)
    : task_(task), jury_(loaded, task), entries_(task.contenders.size()) {}

void ErrorSurvey::prepare(std::span<const std::size_t> who, const std::function<bool()>& goesOn) {
    std::vector<Tuned> untuned;
    for (const std::size_t i : who) {
        const Contender& contender = task_.contenders[i];
        Entry& entry = entries_[i];
        if (entry.renderer) continue;
        RenderSettings settings = contender.settings;
        settings.layout = contender.layout.value_or(jury_.studio().bestLayout());
        entry.renderer = std::make_unique<Renderer>(jury_.studio().rendererFor(settings));
        if (contender.tuneMapBias) untuned.push_back({&contender, entry.renderer.get()});
    }
    tuneBiases(jury_, task_, untuned, goesOn);
    std::size_t next = 0;
    for (const std::size_t i : who)
        if (next < untuned.size() && untuned[next].contender == &task_.contenders[i])
            entries_[i].bias = untuned[next++].bias;
}

std::vector<WrongCounts> ErrorSurvey::count(std::size_t view, std::span<const std::size_t> who) {
    jury_.see(task_.views[view]);
    std::vector<WrongCounts> counts;
    for (const std::size_t i : who)
        counts.push_back(jury_.countWrongImage(*entries_[i].renderer, task_.contenders[i]));
    return counts;
}

} // namespace edgeshade::lab
