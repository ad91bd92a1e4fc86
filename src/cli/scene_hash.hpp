#pragma once

#include "preprocess/scene/scene.hpp"

#include <string>

namespace edgeshade::cli {

/// A hash of all triangles and their positions: 64-bit FNV-1a, 16 digits.
std::string hashOf(const Scene& scene);

} // namespace edgeshade::cli
