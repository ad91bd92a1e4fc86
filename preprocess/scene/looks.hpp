#pragma once

#include "preprocess/scene/material.hpp"

#include <string>

namespace edgeshade {

/// How a file's surfaces look.
struct Looks {
    std::string variant;             ///< in KHR_materials_variants; empty: the file's own materials
    Shading shading = Shading::full; ///< how much of a material is read
};

} // namespace edgeshade
