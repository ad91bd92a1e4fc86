#pragma once

#include "src/lab/oracle.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace edgeshade::lab {

/// One view's pictures, RGBA rows top to bottom, all of the question's size.
struct Pictures {
    using Unshadowed = std::function<std::vector<std::uint8_t>(const LightSet& lights)>;
    using LitAs = std::function<std::vector<std::uint8_t>(const std::vector<Answer>&)>;

    std::vector<std::uint8_t> mask;  ///< the program's lit mask of light 0
    std::vector<std::uint8_t> image; ///< the program's picture
    /// The program's picture without shadows, lit only by the given lights. The oracle's picture
    /// takes each pixel from such pictures, whatever the shading.
    Unshadowed unshadowed;
    /// The same for all pixels at once, each with the lights of its answer, for so many lights that
    /// hardly two pixels have the same. Null: not used.
    LitAs litAs;
};

} // namespace edgeshade::lab
