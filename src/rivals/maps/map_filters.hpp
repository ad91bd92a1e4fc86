#pragma once

#include "src/render/shadow_map/shadow_map.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// Whether a map's distances are filtered before receivers read them.
bool isFiltered(const ShadowMapSettings& settings);

/// Texels of a texture, side by side, that a map's texel takes.
int texelWidthOf(const ShadowMapSettings& settings);

/// Share of light in half shadow that is taken for light that bleeds through several casters, 0..1.
float bleedingShareOf(const ShadowMapSettings& settings);

/// #defines of a filter other than comparing, see shaders_es2/rivals/maps; none: compared.
std::vector<std::string> filterDefines(MapFilter filter);

/// The filter, for people: "four moments".
std::string filterWordsOf(MapFilter filter);

} // namespace edgeshade
