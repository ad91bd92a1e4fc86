#pragma once

#include "src/environment/environment.hpp"

namespace edgeshade {

/// Radiance of the neutral sky and ground at the sine of an elevation, -1 to 1. It is grey,
/// brighter above than below, with a band of light along the horizon and a soft light overhead for
/// metal to reflect. Its mean over all directions is 1.
float neutralRadiance(float height);

/// The default environment. It reads no file.
Environment neutralEnvironment();

} // namespace edgeshade
