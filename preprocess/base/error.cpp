#include "preprocess/base/error.hpp"

#include <algorithm>

namespace edgeshade {

std::string clauseOf(std::string message) {
    const std::size_t last = message.find_last_not_of(". \n\r\t");
    message.resize(last == std::string::npos ? 0 : last + 1);
    std::replace(message.begin(), message.end(), '\n', ' ');
    return message;
}

} // namespace edgeshade
