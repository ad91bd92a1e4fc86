#pragma once

#include "preprocess/base/file_io.hpp"

#include <algorithm>
#include <string_view>

namespace edgeshade::city {

/// Bytes as text.
inline std::string_view textOf(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Calls read(line, number) for each line that isn't blank; the first has the number 1.
template <class Read>
void forEachLine(std::string_view text, Read read) {
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        at = end + 1;
        ++number;
        if (line.find_first_not_of(" \t\r") != std::string_view::npos) read(line, number);
    }
}

} // namespace edgeshade::city
