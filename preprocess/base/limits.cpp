#include "preprocess/base/limits.hpp"

#include "preprocess/base/error.hpp"

#include <limits>

namespace edgeshade {

void MemoryBudget::take(std::uint64_t count, std::uint64_t size, const std::string& where) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t bytes = size != 0 && count > most / size ? most : count * size;
    if (bytes > limits_.memoryBytes - taken_)
        throw LimitError(where + " takes " + std::to_string(bytes) +
                         " bytes of memory in addition to the " + std::to_string(taken_) +
                         " already taken, but the limit is " + std::to_string(limits_.memoryBytes) +
                         ".");
    taken_ += bytes;
}

} // namespace edgeshade
