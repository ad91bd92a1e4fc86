#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace edgeshade {

/// Items that keep their arrays' memory when the vector is cleared, for values that every frame
/// makes again. T::clear() makes an item as new, but for that memory.
template <class T>
class KeptVector {
  public:
    /// Adds an item as new.
    T& add() {
        if (size_ == items_.size()) items_.emplace_back();
        return items_[size_++];
    }
    void push_back(T item) { add() = std::move(item); }
    void clear() {
        for (T& item : *this)
            item.clear();
        size_ = 0;
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T& operator[](std::size_t i) { return items_[i]; }
    const T& operator[](std::size_t i) const { return items_[i]; }
    T* begin() { return items_.data(); }
    T* end() { return items_.data() + size_; }
    const T* begin() const { return items_.data(); }
    const T* end() const { return items_.data() + size_; }
    T& front() { return items_.front(); }
    const T& front() const { return items_.front(); }
    T& back() { return items_[size_ - 1]; }
    const T& back() const { return items_[size_ - 1]; }

  private:
    std::vector<T> items_;
    std::size_t size_ = 0;
};

} // namespace edgeshade
