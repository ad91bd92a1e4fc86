#include "preprocess/base/parallel.hpp"

#include <algorithm>

#ifndef __EMSCRIPTEN__
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#endif

namespace edgeshade {

std::vector<ItemRange> partsOf(std::size_t count, std::size_t least, Threads threads) {
    const std::size_t parts = std::clamp<std::size_t>(count / least, 1, threads.count);
    std::vector<ItemRange> ranges;
    for (std::size_t i = 0; i < parts; ++i)
        ranges.push_back({count * i / parts, count * (i + 1) / parts});
    return ranges;
}

std::vector<std::size_t> toPlaces(std::vector<std::vector<std::size_t>>& counts) {
    std::vector<std::size_t> firsts;
    std::size_t next = 0;
    for (std::size_t bin = 0; bin < counts.front().size(); ++bin) {
        firsts.push_back(next);
        for (std::vector<std::size_t>& part : counts) {
            const std::size_t count = part[bin];
            part[bin] = next;
            next += count;
        }
    }
    firsts.push_back(next);
    return firsts;
}

#ifdef __EMSCRIPTEN__

std::size_t Threads::available() {
    return 1;
}

void inParallel(std::size_t count, Threads, const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i)
        work(i);
}

#else

std::size_t Threads::available() {
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 16);
}

void inParallel(std::size_t count, Threads threads, const std::function<void(std::size_t)>& work) {
    if (count <= 1 || threads.count <= 1) {
        for (std::size_t i = 0; i < count; ++i)
            work(i);
        return;
    }
    std::atomic<std::size_t> next{0};
    std::mutex failing;
    std::exception_ptr failure;
    const auto loop = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++)
                work(i);
        } catch (...) {
            next = count;
            const std::lock_guard lock(failing);
            if (!failure) failure = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others; // joined at the end of the block
        try {
            while (others.size() + 1 < std::min(count, threads.count))
                others.emplace_back(loop);
        } catch (const std::system_error&) {
            // No more threads are available: those already started do the work.
        }
        loop();
    }
    if (failure) std::rethrow_exception(failure);
}

#endif

} // namespace edgeshade
