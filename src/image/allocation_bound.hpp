#pragma once

#include <cstddef>

namespace edgeshade {

/// For its lifetime and in this thread, limits each of stb_image's allocations to `bytes`.
/// stb_image trusts a file's sizes, and doesn't bound what it inflates.
class AllocationBound {
  public:
    explicit AllocationBound(std::size_t bytes);
    ~AllocationBound();
    AllocationBound(const AllocationBound&) = delete;
    AllocationBound& operator=(const AllocationBound&) = delete;
};

} // namespace edgeshade
