#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace edgeshade {

/// At most `most` items, without memory on the heap.
template <class T, std::size_t most>
class InlineVector {
  public:
    /// Throws std::length_error if there is no room.
    void push_back(const T& item) {
        if (size_ == most) throw std::length_error("An InlineVector is full.");
        items_[size_++] = item;
    }
    void clear() { size_ = 0; }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T& operator[](std::size_t i) { return items_[i]; }
    const T& operator[](std::size_t i) const { return items_[i]; }
    T* begin() { return items_.data(); }
    T* end() { return items_.data() + size_; }
    const T* begin() const { return items_.data(); }
    const T* end() const { return items_.data() + size_; }
    const T& front() const { return items_[0]; }
    const T& back() const { return items_[size_ - 1]; }
    operator std::span<const T>() const { return {items_.data(), size_}; }

  private:
    std::array<T, most> items_{};
    std::size_t size_ = 0;
};

} // namespace edgeshade
