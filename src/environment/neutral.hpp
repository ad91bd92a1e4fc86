#pragma once

#include "src/environment/environment.hpp"

namespace edgeshade {

/// Radiance of the neutral sky and ground at the sine of an elevation, -1 to 1: grey, brighter
/// above than below, with a band of light along the horizon and a soft light overhead, so that
/// metal has something to reflect. Its mean over all directions is 1.
float neutralRadiance(float height);

/// The environment that is there when no other is asked for. No file is read.
Environment neutralEnvironment();

} // namespace edgeshade
