#pragma once

#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {

/// One row of the table of parts that are left out with a warning: the sound scene with a fault in
/// its only texture, so that it is drawn with its material's factor.
struct LeftOut {
    std::string name;               ///< an identifier, as GoogleTest requires
    BadInput::Make make;            ///< creates the input in the folder and returns its path
    std::vector<std::string> words; ///< words of the warning, besides the file's name
    std::vector<std::string> verbs; ///< verbs that warn; the first is documented
};

std::vector<LeftOut> leftOutImages();

} // namespace edgeshade::test
