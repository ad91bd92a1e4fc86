#pragma once

#include "src/hours/part.hpp"

namespace edgeshade::hours {

/// A part and its file's path, for messages.
struct PartOfFile {
    std::string path;
    Part part;
};

/// The whole run's part, as if the run had not been split. `parts`: in any order. Throws InputError
/// naming file, field and value: parts of different runs, a repeated part, a missing one.
Part merged(const std::vector<PartOfFile>& parts);

} // namespace edgeshade::hours
