#pragma once

#include "src/city/plan.hpp"

namespace edgeshade::city {

/// Bytes that a job takes at most: of the largest source while it is read, of rays to `casters`
/// triangles, and of its cells with their months and bits. docs/measured/city.md compares it with
/// what jobs took.
std::uint64_t memoryOf(const Job& job, const std::vector<PlannedSource>& sources,
                       std::uint64_t casters, std::size_t resultBytesOfCell);

} // namespace edgeshade::city
