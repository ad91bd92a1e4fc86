#pragma once

#include "src/render/shadow_map/shadow_map.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// What shaders are told of a filter that is `width` texels wide: see shadow_map_lookup.glsl and
/// filtered_distance.glsl of shaders_es2/.
std::vector<std::string> filterDefines(MapFilter filter, int width);

/// What they are told of a map's textures, `faces` as in ShadowMapLookup: see
/// shadow_map_faces.glsl.
std::vector<std::string> faceDefines(ShadowMapKind kind, int faces);

} // namespace edgeshade
