#pragma once

#include "preprocess/base/parallel.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// A key of 32-bit words, the first of which counts most, and what it is the key of.
template <std::size_t words>
struct Keyed {
    std::array<std::uint32_t, words> key;
    std::uint32_t number;
};

/// Sorts by key, equal ones by number; they must be given in the order of their numbers. Takes as
/// much memory again. `words`: 2 or 3.
template <std::size_t words>
void radixSort(std::vector<Keyed<words>>& items, Threads threads);

} // namespace edgeshade
