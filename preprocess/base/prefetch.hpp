#pragma once

namespace edgeshade {

/// Asks for the memory of something that is read a few steps later, where no pattern tells the
/// processor. Changes nothing but the time.
template <class Item>
void prefetch(const Item& item) {
    __builtin_prefetch(&item);
}

} // namespace edgeshade
