#pragma once

#include "preprocess/base/parallel.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// A key of 32-bit words, the first most significant, and the number of its item.
template <std::size_t words>
struct Keyed {
    std::array<std::uint32_t, words> key;
    std::uint32_t number;
};

/// Sorts by key, and equal keys by number; the items must be in the order of their numbers. Needs
/// as much memory again. `words`: 2 or 3.
template <std::size_t words>
void radixSort(std::vector<Keyed<words>>& items, Threads threads);

} // namespace edgeshade
