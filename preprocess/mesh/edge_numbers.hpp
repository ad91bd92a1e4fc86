#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace edgeshade {

/// A number for each edge, by its end points: a hash table without allocations for each entry.
class EdgeNumbers {
  public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// `expected`: number of edges, about; more of them take more time.
    explicit EdgeNumbers(std::size_t expected = 0) : entries_(std::bit_ceil(2 * expected + 64)) {}

    /// The place of the number of the edge between two different vertices; `none` is there if the
    /// edge has none yet, and must then be replaced. Valid until the next call.
    std::uint32_t& at(std::uint32_t a, std::uint32_t b) {
        if (2 * (count_ + 1) > entries_.size()) grow();
        Entry& entry = find({std::min(a, b), std::max(a, b), none});
        if (entry.number == none) {
            ++count_;
            entry.low = std::min(a, b);
            entry.high = std::max(a, b);
        }
        return entry.number;
    }

  private:
    struct Entry {
        std::uint32_t low = 0, high = 0, number = none;
    };

    /// The edge's entry, or the free one where it belongs.
    Entry& find(const Entry& of) {
        const std::uint64_t key = (std::uint64_t{of.low} << 32) | of.high;
        const std::size_t mask = entries_.size() - 1; // the size is a power of two
        std::size_t i = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> 32) & mask;
        while (entries_[i].number != none &&
               (entries_[i].low != of.low || entries_[i].high != of.high))
            i = (i + 1) & mask;
        return entries_[i];
    }

    void grow() {
        std::vector<Entry> before(4 * entries_.size());
        before.swap(entries_);
        for (const Entry& entry : before)
            if (entry.number != none) find(entry) = entry;
    }

    std::vector<Entry> entries_;
    std::size_t count_ = 0;
};

} // namespace edgeshade
