#pragma once

#include "src/lab/oracle.hpp"
#include "src/scene/load.hpp"

namespace edgeshade::lab {

/// Alpha of MASK surfaces from their textures, with their samplers' wrapping and magnification, for
/// the oracle. The scene must outlive it. Throws InputError.
AlphaLookup textureAlpha(const LoadedScene& loaded);

} // namespace edgeshade::lab
