#pragma once

#include <cstddef>
#include <vector>

namespace edgeshade {

/// Gives a vector room for `count` values. Where it has none yet it gets an eighth more, because a
/// later use is likely to need a little more; its values are then lost, not copied.
template <class T>
void reserveReused(std::vector<T>& values, std::size_t count) {
    if (values.capacity() >= count) return;
    values.clear();
    values.reserve(count + count / 8);
}

/// Resizes a vector whose values have no meaning any longer, and are all to be written.
template <class T>
void resizeReused(std::vector<T>& values, std::size_t count) {
    reserveReused(values, count);
    values.resize(count);
}

} // namespace edgeshade
