#pragma once

#include "src/render/shadow_map/shadow_map.hpp"

#include <string>
#include <vector>

namespace edgeshade {

/// Whether a map's distances are filtered before receivers sample them.
bool isFiltered(const ShadowMapSettings& settings);

/// Number of adjacent texture texels that one map texel takes.
int texelWidthOf(const ShadowMapSettings& settings);

/// Share of light in half shadow that counts as light bleeding through several casters, 0..1.
float bleedingShareOf(const ShadowMapSettings& settings);

/// #defines of a filter other than comparing, see shaders_es2/rivals/maps; empty: compared.
std::vector<std::string> filterDefines(MapFilter filter);

/// Describes the filter: "four moments".
std::string filterWordsOf(MapFilter filter);

} // namespace edgeshade
