#pragma once

#include "src/hours/part.hpp"

namespace edgeshade::hours {

/// A part and the file that it came from, for messages.
struct PartOfFile {
    std::string path;
    Part part;
};

/// The whole run's part, which is what the run would have found that had not been split. In any
/// order. Throws InputError that names file, field and value: parts of different runs, a part
/// twice, one missing.
Part merged(const std::vector<PartOfFile>& parts);

} // namespace edgeshade::hours
