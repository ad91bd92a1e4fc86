#include "src/viewer/light_rest.hpp"

#include "src/shadow/lights/light_shape.hpp"

#include <algorithm>

namespace edgeshade::viewer {

void LightRest::see(const std::vector<Light>& lights, double now) {
    std::vector<Known> next;
    for (const Light& light : lights) {
        const auto known = std::find_if(since_.begin(), since_.end(), [&](const Known& of) {
            return castAlike(of.light, light);
        });
        next.push_back({light, known == since_.end() ? now : known->since});
    }
    since_ = std::move(next);
}

bool LightRest::rests(const Light& light, double now) const {
    return std::any_of(since_.begin(), since_.end(), [&](const Known& of) {
        return castAlike(of.light, light) && now - of.since >= enough;
    });
}

} // namespace edgeshade::viewer
