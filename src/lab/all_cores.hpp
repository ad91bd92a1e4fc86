#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace edgeshade::lab {

/// Calls work(index) for indices 0 to count - 1 on all cores, including the caller's thread.
template <class Work>
void onAllCores(std::size_t count, Work work) {
    std::atomic<std::size_t> next{0};
    const auto loop = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
        others.emplace_back(loop);
    loop();
    for (std::thread& other : others)
        other.join();
}

} // namespace edgeshade::lab
