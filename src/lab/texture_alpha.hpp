#pragma once

#include "src/lab/oracle.hpp"
#include "src/scene/load.hpp"

namespace edgeshade::lab {

/// Alpha of MASK surfaces by their textures, as their samplers wrap and magnify them, for the
/// oracle. The scene must outlive it. Throws InputError.
AlphaLookup textureAlpha(const LoadedScene& loaded);

} // namespace edgeshade::lab
