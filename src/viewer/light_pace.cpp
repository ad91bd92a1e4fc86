#include "src/viewer/light_pace.hpp"

#include "src/shadow/geometry/light_region.hpp"

namespace edgeshade::viewer {

void LightPace::see(const std::vector<Light>& lights, double now) {
    if (lights.size() != known_.size()) {
        known_.clear();
        for (const Light& light : lights)
            known_.push_back({light});
        since_ = now;
        return;
    }
    const double passed = now - since_;
    if (passed < span) return;
    for (std::size_t i = 0; i < lights.size(); ++i)
        known_[i] = {lights[i], placesApart(lights[i].position, known_[i].light.position) / passed};
    since_ = now;
}

double LightPace::wanderOf(std::size_t light, double sceneSize) const {
    if (light >= known_.size()) return 0.0;
    const Known& of = known_[light];
    const double wander = ahead * of.speed;
    return wander > 0.0 && wander <= mostWander(of.light, sceneSize) ? wander : 0.0;
}

} // namespace edgeshade::viewer
