#pragma once

#include "preprocess/base/parallel.hpp"

#include <thread>
#include <type_traits>

namespace edgeshade::lab {

/// at(x, y) for all pixel centres of a picture, rows top to bottom, on all cores. `progress`
/// receives the share done, from the caller's thread alone; it may be null.
template <class At>
auto atAllPixels(int width, int height, const At& at,
                 const std::function<void(double)>& progress = {}) {
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    std::vector<std::invoke_result_t<At, double, double>> values(columns * rows);
    const std::thread::id caller = std::this_thread::get_id();
    inParallel(rows, {}, [&](std::size_t y) {
        for (std::size_t x = 0; x < columns; ++x)
            values[y * columns + x] =
                at(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
        if (progress && std::this_thread::get_id() == caller)
            progress(static_cast<double>(y + 1) / height);
    });
    return values;
}

} // namespace edgeshade::lab
