#include "src/viewer/sun_following.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

/// Whether the sun's light has been moved away from the sun's own direction.
bool wasMoved(const ViewState& before, const ViewState& next) {
    return before.sun && next.sun == before.sun && !before.lights.empty() &&
           next.lights.front().position != before.lights.front().position;
}

} // namespace

ViewState withSun(const ViewState& before, ViewState next) {
    if (next.lights.empty() || wasMoved(before, next)) next.sun.reset();
    if (!next.sun) {
        next.dayPlays = next.sunHours = false;
        return next;
    }
    const bool isThere = before.sun || next.lights.front().position.w == 0.0;
    if (!isThere && next.lights.size() < mostLights)
        next.lights.insert(next.lights.begin(), Light());
    if (!before.sun) next.chosenLight = 0;
    Light& light = next.lights.front();
    if (light.position.w != 0.0) light = Light();
    light.position = glm::dvec4(next.sun->direction(), 0.0);
    return next;
}

bool sunIsDown(const ViewState& state) {
    return state.sun && !state.sun->position().isUp();
}

} // namespace edgeshade::viewer
