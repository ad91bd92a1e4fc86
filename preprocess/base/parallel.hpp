#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace edgeshade {

/// Threads that a stage may use. The result is the same for any number.
struct Threads {
    std::size_t count = available();

    /// Threads that the machine runs at once, 1 to 16; 1 in WebAssembly.
    static std::size_t available();
};

/// Small items (triangles, edges) below which starting a thread takes longer than it saves.
constexpr std::size_t itemsOfThread = std::size_t{1} << 14;

/// Items [first, end).
struct ItemRange {
    std::size_t first = 0;
    std::size_t end = 0;

    std::size_t size() const { return end - first; }
};

/// Divides items [0, count) into equal ranges, one per thread; fewer where a range would have less
/// than `least` items. At least one range.
std::vector<ItemRange> partsOf(std::size_t count, std::size_t least, Threads threads);

/// Calls work(0) to work(count - 1), several at once, and returns when all are done. Rethrows the
/// exception of the first that fails.
void inParallel(std::size_t count, Threads threads, const std::function<void(std::size_t)>& work);

/// Calls work(part, range) for each of `parts`, all at once.
template <class Work>
void forEachPart(const std::vector<ItemRange>& parts, const Work& work) {
    inParallel(parts.size(), {parts.size()}, [&](std::size_t part) { work(part, parts[part]); });
}

/// Calls work(item) for items [0, count), in parts of at least `least`.
template <class Work>
void forEachItem(std::size_t count, std::size_t least, Threads threads, const Work& work) {
    forEachPart(partsOf(count, least, threads), [&](std::size_t, const ItemRange& range) {
        for (std::size_t i = range.first; i < range.end; ++i)
            work(i);
    });
}

/// Turns each part's count into the index of its first item; returns the sum.
template <class Number>
Number toFirsts(std::vector<Number>& counts) {
    Number sum = 0;
    for (Number& count : counts) {
        const Number own = count;
        count = sum;
        sum += own;
    }
    return sum;
}

/// Turns `counts`, by part and bin, into the index where each part's items of each bin go: bin
/// after bin, the parts in order within a bin. Returns the first index of each bin and, last, the
/// end.
std::vector<std::size_t> toPlaces(std::vector<std::vector<std::size_t>>& counts);

/// Closes the gaps between parts: each wrote `counts` items at the start of its own range of
/// `items`. Keeps their order.
template <class Item>
void closeGaps(std::vector<Item>& items, const std::vector<ItemRange>& parts,
               const std::vector<std::size_t>& counts) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto from = items.begin() + static_cast<std::ptrdiff_t>(parts[i].first);
        if (end != parts[i].first)
            std::move(from, from + static_cast<std::ptrdiff_t>(counts[i]),
                      items.begin() + static_cast<std::ptrdiff_t>(end));
        end += counts[i];
    }
    items.resize(end);
}

} // namespace edgeshade
