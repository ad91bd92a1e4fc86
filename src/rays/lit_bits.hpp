#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace edgeshade::rays {

/// Whether light from some directions reaches some points: a bit for each pair.
class LitBits {
  public:
    LitBits(std::size_t points, std::size_t directions)
        : directions_(directions), words_((directions + 63) / 64), bits_(points * words_) {}

    std::size_t points() const { return words_ == 0 ? 0 : bits_.size() / words_; }
    std::size_t directions() const { return directions_; }

    bool at(std::size_t point, std::size_t direction) const {
        return (of(point)[direction / 64] >> direction % 64 & 1) != 0;
    }
    /// A point's bits: bit d % 64 of word d / 64 is direction d's; bits beyond the last are 0.
    std::span<const std::uint64_t> of(std::size_t point) const {
        return std::span(bits_).subspan(point * words_, words_);
    }
    /// The number of directions from which light reaches a point.
    std::size_t count(std::size_t point) const {
        std::size_t count = 0;
        for (const std::uint64_t word : of(point))
            count += static_cast<std::size_t>(std::popcount(word));
        return count;
    }
    void setLit(std::size_t point, std::size_t direction) {
        bits_[point * words_ + direction / 64] |= std::uint64_t{1} << direction % 64;
    }
    void setDark(std::size_t point, std::size_t direction) {
        bits_[point * words_ + direction / 64] &= ~(std::uint64_t{1} << direction % 64);
    }

  private:
    std::size_t directions_, words_;
    std::vector<std::uint64_t> bits_;
};

} // namespace edgeshade::rays
