#include "src/render/shadow_map/map_defines.hpp"

#include "src/render/shadow_map/map_warp.hpp"

namespace edgeshade {

std::vector<std::string> filterDefines(MapFilter filter, int width) {
    std::vector<std::string> defines = {"PCF " + std::to_string(width)};
    if (filter == MapFilter::poisson) defines.emplace_back("POISSON");
    if (filter == MapFilter::variance) defines.emplace_back("VSM");
    if (filter == MapFilter::exponential) defines.emplace_back("ESM");
    if (filter == MapFilter::moments) defines.emplace_back("MSM");
    return defines;
}

std::vector<std::string> faceDefines(ShadowMapKind kind, int faces) {
    std::vector<std::string> defines;
    if (faces > 0) defines.push_back("MAP_FACES " + std::to_string(faces));
    if (isParallel(kind)) defines.emplace_back("MAP_DIRECTIONAL");
    if (kind == ShadowMapKind::paraboloid) defines.emplace_back("MAP_PARABOLOID");
    if (kind == ShadowMapKind::cascades) defines.push_back("MAP_CASCADES " + std::to_string(faces));
    if (kind == ShadowMapKind::warped)
        defines.push_back("MAP_WARPED " + std::to_string(MapWarp::cells));
    return defines;
}

} // namespace edgeshade
