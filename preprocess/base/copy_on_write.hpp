#pragma once

#include <memory>
#include <utility>

namespace edgeshade {

/// A value that copies share until one of them is edited, so that a copy costs a pointer.
template <class T>
class CopyOnWrite {
  public:
    CopyOnWrite() : value_(std::make_shared<T>()) {}
    explicit CopyOnWrite(T value) : value_(std::make_shared<T>(std::move(value))) {}

    /// A value that others may hold; they must not change it.
    explicit CopyOnWrite(std::shared_ptr<T> value) : value_(std::move(value)) {}

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }

    /// The value, copied first if it was shared, so that this is its only owner. Not for two
    /// threads at once.
    T& edit() {
        if (value_.use_count() > 1) value_ = std::make_shared<T>(*value_);
        return *value_;
    }

  private:
    std::shared_ptr<T> value_;
};

} // namespace edgeshade
