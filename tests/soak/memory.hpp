#pragma once

#include <cstddef>
#include <fstream>
#include <unistd.h>

namespace edgeshade::test {

/// Resident memory of this process, in bytes.
inline std::size_t residentBytes() {
    std::ifstream file("/proc/self/statm");
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

inline double megabytes(std::size_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

} // namespace edgeshade::test
