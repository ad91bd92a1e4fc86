#include "src/viewer/light_rest.hpp"

#include <algorithm>

namespace edgeshade::viewer {

void LightRest::see(const std::vector<Light>& lights, double now) {
    std::vector<std::pair<glm::dvec4, double>> next;
    for (const Light& light : lights) {
        const auto known = std::find_if(since_.begin(), since_.end(),
                                        [&](const auto& of) { return of.first == light.position; });
        next.emplace_back(light.position, known == since_.end() ? now : known->second);
    }
    since_ = std::move(next);
}

bool LightRest::rests(const Light& light, double now) const {
    return std::any_of(since_.begin(), since_.end(), [&](const auto& of) {
        return of.first == light.position && now - of.second >= enough;
    });
}

} // namespace edgeshade::viewer
