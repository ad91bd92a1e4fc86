#pragma once

namespace edgeshade {

/// Prefetches an item read a few steps later at an address the processor can't predict. Affects
/// only the time.
template <class Item>
void prefetch(const Item& item) {
    __builtin_prefetch(&item);
}

} // namespace edgeshade
