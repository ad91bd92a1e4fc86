#pragma once

#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgeshade::lab {

/// A subset of a picture's lights. Allocates memory only for lights beyond the first 64.
class LightSet {
  public:
    LightSet() = default;
    /// Bit i stands for light i.
    LightSet(std::uint64_t first) : first_(first) {}

    void add(std::size_t light) {
        if (light < 64) {
            first_ |= std::uint64_t{1} << light;
            return;
        }
        const std::size_t word = light / 64 - 1;
        if (more_.size() <= word) more_.resize(word + 1, 0);
        more_[word] |= std::uint64_t{1} << light % 64;
    }
    bool has(std::size_t light) const {
        const std::size_t word = light / 64;
        if (word > more_.size()) return false;
        return ((word == 0 ? first_ : more_[word - 1]) >> light % 64 & 1) != 0;
    }
    std::size_t countOfFirst(std::size_t lights) const {
        const std::uint64_t all = ~std::uint64_t{0};
        return static_cast<std::size_t>(
            std::popcount(first_ & (lights >= 64 ? all : ~(all << lights))));
    }

    bool operator==(const LightSet&) const = default;
    auto operator<=>(const LightSet&) const = default;

  private:
    std::uint64_t first_ = 0;
    std::vector<std::uint64_t> more_; ///< 64 lights each; the last one is not 0
};

} // namespace edgeshade::lab
