#include "src/render/shadow_map/map_words.hpp"

#include "src/render/shadow_map/shadow_map_view.hpp"

namespace edgeshade {
namespace {

std::string facesOf(ShadowMapKind kind, const ShadowMapSettings& settings) {
    switch (kind) {
    case ShadowMapKind::directional:
        return "one map";
    case ShadowMapKind::cascades:
        return "up to " + std::to_string(settings.cascades) + " cascades";
    case ShadowMapKind::paraboloid:
        return "two paraboloids";
    case ShadowMapKind::warped:
        return settings.warp == WarpGrid::rectilinear
                   ? "one map, warped along its columns and rows,"
                   : "one map, warped by a non-orthogonal grid,";
    default:
        return "a cube's six faces";
    }
}

const char* filterOf(MapFilter filter) {
    switch (filter) {
    case MapFilter::poisson:
        return "Poisson taps";
    case MapFilter::variance:
        return "variance";
    case MapFilter::exponential:
        return "exponential";
    case MapFilter::moments:
        return "four moments";
    default:
        return "compared";
    }
}

} // namespace

std::string mapWords(const Light& light, const ShadowMapSettings& settings) {
    const std::string size = std::to_string(settings.size), wide = std::to_string(settings.pcf);
    std::string words =
        facesOf(mapKindOf(light, settings), settings) + " of " + size + " x " + size + " texels, ";
    if (settings.soft == SoftShadows::pcss && light.extent)
        return words + "percentage-closer soft shadows";
    return words + filterOf(settings.filter) + ", " + wide + " wide";
}

} // namespace edgeshade
