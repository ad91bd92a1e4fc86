#pragma once

#include "preprocess/file_io.hpp"

#include <string>
#include <utility>
#include <vector>

namespace edgeshade::test {

/// Sound inputs that fuzzers start from, by name.
using Seeds = std::vector<std::pair<std::string, Bytes>>;

Seeds gltfSeeds();        ///< everything that reading knows, a little of each
Seeds compressionSeeds(); ///< Draco and meshopt, every mode and filter
Seeds shadowSeeds();      ///< packed files of every encoding
Seeds packSeeds();        ///< for each section of glTF one that has all others; packed files
Seeds imageSeeds();

} // namespace edgeshade::test
