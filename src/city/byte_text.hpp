#pragma once

#include "preprocess/base/file_io.hpp"

#include <string_view>

namespace edgeshade::city {

/// Bytes as text.
inline std::string_view textOf(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace edgeshade::city
