#pragma once

#include "preprocess/base/file_io.hpp"

#include <string>
#include <utility>
#include <vector>

namespace edgeshade::test {

/// Sound inputs for fuzzers to start from, by name.
using Seeds = std::vector<std::pair<std::string, Bytes>>;

Seeds gltfSeeds();        ///< a little of everything that reading supports
Seeds compressionSeeds(); ///< Draco and meshopt, every mode and filter
Seeds shadowSeeds();      ///< packed files of every encoding
Seeds packSeeds();        ///< for each section of glTF a file without it and all others; packed
                          ///< files
Seeds imageSeeds();

} // namespace edgeshade::test
