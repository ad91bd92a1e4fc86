#pragma once

#include <cstddef>

namespace edgeshade {

/// For its lifetime and in this thread, stb_image gets no piece of memory larger than `bytes`. It
/// takes what a file claims, and what inflates, for granted.
class AllocationBound {
  public:
    explicit AllocationBound(std::size_t bytes);
    ~AllocationBound();
    AllocationBound(const AllocationBound&) = delete;
    AllocationBound& operator=(const AllocationBound&) = delete;
};

} // namespace edgeshade
