#include "src/viewer/caster_groups.hpp"

#include "src/shadow/geometry/frame_view.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::viewer {
namespace {

GroupedShadow groupsFor(const Light& light, const LoadedScene& loaded, VolumeRecords records) {
    const LayerBound bound =
        boundLayers(loaded.scene, loaded.settings.castMasked, light, stencilLimit);
    if (bound.groupCount <= 1) return {};
    return uploadGroups(loaded, bound.groupOf, bound.groupCount, records);
}

} // namespace

const std::vector<GroupedShadow>& CasterGroups::of(const std::vector<Light>& lights,
                                                   const LoadedScene& loaded,
                                                   VolumeRecords records) {
    std::vector<glm::dvec4> places;
    std::vector<GroupedShadow> groups;
    for (const Light& light : lights) {
        places.push_back(light.position);
        const auto kept = std::find(lights_.begin(), lights_.end(), light.position);
        if (kept == lights_.end()) {
            groups.push_back(groupsFor(light, loaded, records));
            continue;
        }
        groups.push_back(std::move(groups_[static_cast<std::size_t>(kept - lights_.begin())]));
        *kept = glm::dvec4(NAN); // taken; a second light at the same place gets groups of its own
    }
    lights_ = std::move(places);
    groups_ = std::move(groups);
    return groups_;
}

} // namespace edgeshade::viewer
