#pragma once

#include "src/lab/oracle.hpp"
#include "src/scene/load.hpp"

namespace edgeshade::lab {

/// Alpha of MASK surfaces by their textures, nearest texel, for the oracle. The scene must outlive
/// it. Throws InputError.
AlphaAt textureAlpha(const LoadedScene& loaded);

} // namespace edgeshade::lab
