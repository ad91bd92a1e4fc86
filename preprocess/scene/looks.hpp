#pragma once

#include "preprocess/scene/material.hpp"

#include <string>

namespace edgeshade {

/// How a file's surfaces are to look.
struct Looks {
    std::string variant;             ///< of KHR_materials_variants; empty: the file's own materials
    Shading shading = Shading::full; ///< what of materials is read at all
};

} // namespace edgeshade
