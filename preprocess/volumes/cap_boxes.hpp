#pragma once

#include "preprocess/base/parallel.hpp"
#include "preprocess/volumes/plane_pair_records.hpp"

#include <cstddef>
#include <vector>

namespace edgeshade {

/// The box of caps [first, end).
Box boxOf(const std::vector<CapRecord>& caps, std::size_t first, std::size_t end);

/// Fills in the boxes of the clusters' leaves.
void addLeaves(Threads threads, PlanePairShadow& shadow);

} // namespace edgeshade
