#pragma once

#include "src/scene/load.hpp"

namespace edgeshade {

/// A box around all that lights shine on, where it is now, in the world.
Box receiversOf(const LoadedScene& loaded);

} // namespace edgeshade
