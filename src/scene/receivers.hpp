#pragma once

#include "src/scene/load.hpp"

namespace edgeshade {

/// A box in the world around all surfaces that receive light, where they are now.
Box receiversOf(const LoadedScene& loaded);

} // namespace edgeshade
