#include "src/viewer/light_following.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

constexpr double tolerance = 1e-5; // relative

bool isNear(double a, double b, double size) {
    return a == b || std::abs(a - b) <= tolerance * size; // also true for equal infinities
}

bool isNear(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::distance(a, b) <= tolerance * std::max(glm::length(a), glm::length(b));
}

bool isSame(const Light& a, const Light& b) {
    if (a.position.w != b.position.w || a.photometric != b.photometric || a.isSpot() != b.isSpot())
        return false;
    if (a.isSpot() &&
        !(isNear(a.cone->axis, b.cone->axis) && isNear(a.cone->inner, b.cone->inner, 1.0) &&
          isNear(a.cone->outer, b.cone->outer, 1.0)))
        return false;
    return isNear(glm::dvec3(a.position), glm::dvec3(b.position)) &&
           isNear(glm::dvec3(a.color), glm::dvec3(b.color)) && isNear(a.range, b.range, a.range);
}

} // namespace

void followLights(std::vector<Light>& lights, const std::vector<Light>& before,
                  const std::vector<Light>& now) {
    const auto indexIn = [](const std::vector<Light>& all, const Light& light) {
        return static_cast<std::size_t>(
            std::find_if(all.begin(), all.end(),
                         [&](const Light& other) { return isSame(light, other); }) -
            all.begin());
    };
    for (std::size_t i = 0; i < lights.size(); ++i) {
        Light& light = lights[i];
        // The light at the same index first: another may be where this one was.
        const bool own = i < now.size() && (isSame(light, before[i]) || isSame(light, now[i]));
        std::size_t index = own ? i : indexIn(before, light);
        if (index == now.size()) index = indexIn(now, light);
        if (index == now.size()) continue;
        const std::optional<LightExtent> extent = light.extent; // lights of files have no extent
        light = now[index];
        light.extent = extent;
    }
}

} // namespace edgeshade::viewer
