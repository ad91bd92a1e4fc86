#include "preprocess/base/radix_sort.hpp"

#include <algorithm>
#include <span>

namespace edgeshade {
namespace {

constexpr unsigned digitBits = 11; // its 2048 bins write to as many cache lines as fit the
                                   // first-level cache
constexpr std::size_t digits = std::size_t{1} << digitBits;
using Counts = std::array<std::uint32_t, digits>;

/// Up to this many items, sorting by comparison is faster.
constexpr std::size_t fewItems = 256;

std::uint32_t digitOf(std::uint32_t word, unsigned shift) {
    return word >> shift & (digits - 1);
}

/// Sorts by one digit, `from` to `to`. Returns false, having done nothing, if all items have the
/// same digit.
template <std::size_t words>
bool sortByDigit(std::span<const Keyed<words>> from, std::span<Keyed<words>> to, std::size_t word,
                 unsigned shift, const std::vector<ItemRange>& parts, std::vector<Counts>& counts) {
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        Counts& own = counts[part];
        own.fill(0);
        for (std::size_t i = range.first; i < range.end; ++i)
            ++own[digitOf(from[i].key[word], shift)];
    });
    std::uint32_t next = 0;
    for (std::size_t digit = 0; digit < digits; ++digit) {
        const std::uint32_t first = next;
        for (Counts& of : counts) {
            const std::uint32_t count = of[digit];
            of[digit] = next;
            next += count;
        }
        if (next - first == from.size()) return false;
    }
    forEachPart(parts, [&](std::size_t part, const ItemRange& range) {
        Counts& place = counts[part];
        for (std::size_t i = range.first; i < range.end; ++i)
            to[place[digitOf(from[i].key[word], shift)]++] = from[i];
    });
    return true;
}

template <std::size_t words>
class Sorter {
  public:
    Sorter(std::span<Keyed<words>> items, std::span<Keyed<words>> spare)
        : items_(items), spare_(spare) {}

    /// Sorts the items of one `range`, whose words before `word` are equal.
    void sort(const ItemRange& range, std::size_t word, Threads threads) const {
        if (word == words || range.size() < 2) return; // already in the order of their numbers
        if (range.size() <= fewItems) return compare(range, word);
        sortByWord(range, word, threads);
        if (items_[range.first].key[word] == items_[range.end - 1].key[word])
            return sort(range, word + 1, threads);
        const std::vector<ItemRange> parts = partsBetweenRuns(range, word, threads);
        forEachPart(parts, [&](std::size_t, const ItemRange& part) {
            for (std::size_t first = part.first; first < part.end;) {
                const std::size_t end = endOfRun(first, part.end, word);
                sort({first, end}, word + 1, {1});
                first = end;
            }
        });
    }

  private:
    void compare(const ItemRange& range, std::size_t word) const {
        std::sort(items_.begin() + static_cast<std::ptrdiff_t>(range.first),
                  items_.begin() + static_cast<std::ptrdiff_t>(range.end),
                  [word](const Keyed<words>& a, const Keyed<words>& b) {
                      for (std::size_t w = word; w < words; ++w)
                          if (a.key[w] != b.key[w]) return a.key[w] < b.key[w];
                      return a.number < b.number;
                  });
    }

    void sortByWord(const ItemRange& range, std::size_t word, Threads threads) const {
        std::span<Keyed<words>> from = items_.subspan(range.first, range.size());
        std::span<Keyed<words>> to = spare_.subspan(range.first, range.size());
        const std::vector<ItemRange> parts = partsOf(range.size(), itemsOfThread, threads);
        std::vector<Counts> counts(parts.size());
        for (unsigned shift = 0; shift < 32; shift += digitBits)
            if (sortByDigit<words>(from, to, word, shift, parts, counts)) std::swap(from, to);
        if (from.data() != &items_[range.first]) std::copy(from.begin(), from.end(), to.begin());
    }

    /// The end of the run of equal words that begins at `first`.
    std::size_t endOfRun(std::size_t first, std::size_t end, std::size_t word) const {
        const std::uint32_t key = items_[first].key[word];
        while (first < end && items_[first].key[word] == key)
            ++first;
        return first;
    }

    std::vector<ItemRange> partsBetweenRuns(const ItemRange& range, std::size_t word,
                                            Threads threads) const {
        std::vector<ItemRange> parts = partsOf(range.size(), itemsOfThread, threads);
        std::size_t first = range.first;
        for (ItemRange& part : parts) {
            const std::size_t end = std::max(first, range.first + part.end);
            part = {first, end == first ? end : endOfRun(end - 1, range.end, word)};
            first = part.end;
        }
        return parts;
    }

    const std::span<Keyed<words>> items_, spare_;
};

} // namespace

template <std::size_t words>
void radixSort(std::vector<Keyed<words>>& items, Threads threads) {
    std::vector<Keyed<words>> spare(items.size() > fewItems ? items.size() : 0);
    Sorter<words>(items, spare).sort({0, items.size()}, 0, threads);
}

template void radixSort(std::vector<Keyed<2>>& items, Threads threads);
template void radixSort(std::vector<Keyed<3>>& items, Threads threads);

} // namespace edgeshade
