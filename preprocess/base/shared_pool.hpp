#pragma once

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

namespace edgeshade {

/// Values that are shared for a while and made again and again. When nobody holds one any longer,
/// the memory of its arrays serves a later one. A value's holders may be in other threads.
template <class T>
class SharedPool {
  public:
    /// A value that was shared and that nobody holds now, as it was left; otherwise an empty one.
    T take() {
        for (auto item = items_.begin(); item != items_.end(); ++item) {
            if (item->use_count() > 1) continue;
            std::atomic_thread_fence(std::memory_order_acquire); // after its holders' last use
            T taken = std::move(**item);
            items_.erase(item); // weak pointers to it expire
            return taken;
        }
        return T();
    }

    /// Shares a value.
    std::shared_ptr<T> share(T value) {
        return items_.emplace_back(std::make_shared<T>(std::move(value)));
    }

    /// Lets go of all values.
    void clear() { items_.clear(); }

  private:
    std::vector<std::shared_ptr<T>> items_;
};

} // namespace edgeshade
