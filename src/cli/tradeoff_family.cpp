#include "src/cli/tradeoff_family.hpp"

#include <algorithm>

namespace edgeshade::cli {
namespace {

std::string familyOfMap(const DrawSettings& settings) {
    const MapKind kind = settings.render.map.kind;
    if (kind != MapKind::cube) return wordOf(settings::mapKind.domain, kind);
    const std::string filter = wordOf(settings::filter.domain, settings.filter);
    return filter == "none" ? "maps" : "maps, " + filter;
}

std::string familyOfVolumes(const DrawSettings& settings) {
    if (settings.casters.any()) return "coarser casters";
    if (settings.render.maskScale > 1) return "coarser masks";
    if (settings.layout == VolumeLayout::planePairs) return "volumes";
    return "volumes, " + std::string(wordOf(settings::layout.domain, settings.layout));
}

} // namespace

std::string familyOf(const DrawSettings& settings) {
    const ShadowMethod method = settings.render.shadows;
    if (method == ShadowMethod::map) return familyOfMap(settings);
    if (method == ShadowMethod::volumes) return familyOfVolumes(settings);
    if (method == ShadowMethod::none) return "no shadows";
    std::string name = wordOf(settings::shadows.domain, method);
    std::ranges::replace(name, '-', ' ');
    return name;
}

std::vector<std::string> allFamilies(const std::vector<std::string>& families) {
    std::vector<std::string> all = {"volumes",       "volumes, published",
                                    "coarser masks", "coarser casters",
                                    "primitive map", "maps",
                                    "maps, pcf",     "maps, poisson",
                                    "maps, vsm",     "maps, esm",
                                    "cascades",      "paraboloid",
                                    "no shadows",    "volumes, brute-force",
                                    "planar",        "warped",
                                    "maps, msm",     "irregular z buffer"};
    for (const std::string& family : families)
        if (std::ranges::find(all, family) == all.end()) all.push_back(family);
    return all;
}

} // namespace edgeshade::cli
