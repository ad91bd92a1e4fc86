#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

namespace edgeshade {

/// Four boxes side by side.
template <class Number>
struct FourBoxes {
    using Lane = std::array<Number, 4>;
    std::array<Lane, 3> low, high; ///< by axis
};

/// Boxes around items in a fixed order: one for each item, one around every four of these, and so
/// on up to a level of four or less. Takes 8 numbers an item.
template <class Number>
class BoxTree {
  public:
    static constexpr std::size_t arity = 4;
    static constexpr std::size_t mostLevels = 16; ///< items have numbers of 32 bits
    using Vector = glm::vec<3, Number>;

    BoxTree() = default;
    explicit BoxTree(std::size_t items) {
        for (std::size_t count = items; count > 0;) {
            const std::size_t groups = (count + arity - 1) / arity;
            levels_.push_back({groups_.size(), count});
            groups_.resize(groups_.size() + groups);
            count = groups > 1 ? groups : 0;
        }
    }

    std::size_t items() const { return levels_.empty() ? 0 : levels_.front().count; }
    /// 0 if there are no items.
    std::size_t levels() const { return levels_.size(); }
    /// Number of boxes of a level; level 0 has the items'.
    std::size_t count(std::size_t level) const { return levels_[level].count; }
    /// The boxes of a level from number 4 * group on; beyond its count they have no meaning.
    const FourBoxes<Number>& group(std::size_t level, std::size_t group) const {
        return groups_[numberOf(level, group)];
    }
    /// Numbers groups of all levels, from 0 to groups().
    std::size_t numberOf(std::size_t level, std::size_t group) const {
        return levels_[level].first + group;
    }
    std::size_t groups() const { return groups_.size(); }

    /// Sets an item's box. Call fit() when all are set.
    void set(std::size_t item, const Vector& low, const Vector& high) {
        put(groups_[item / arity], item % arity, low, high);
    }

    /// Sets an item's box to that of an item of another tree.
    void copy(std::size_t item, const BoxTree& from, std::size_t of) {
        const FourBoxes<Number>& boxes = from.groups_[of / arity];
        FourBoxes<Number>& group = groups_[item / arity];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            group.low[axis][item % arity] = boxes.low[axis][of % arity];
            group.high[axis][item % arity] = boxes.high[axis][of % arity];
        }
    }

    /// Fits the boxes of the other levels to those of the items.
    void fit() {
        for (std::size_t level = 1; level < levels_.size(); ++level)
            for (std::size_t i = 0; i < levels_[level].count; ++i)
                fit(level, i);
    }

  private:
    struct Level {
        std::size_t first; ///< its first group
        std::size_t count; ///< of boxes
    };

    static void put(FourBoxes<Number>& group, std::size_t lane, const Vector& low,
                    const Vector& high) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            group.low[axis][lane] = low[static_cast<glm::length_t>(axis)];
            group.high[axis][lane] = high[static_cast<glm::length_t>(axis)];
        }
    }

    void fit(std::size_t level, std::size_t i) {
        const FourBoxes<Number>& below = group(level - 1, i);
        const std::size_t lanes = std::min(arity, levels_[level - 1].count - arity * i);
        Vector low(std::numeric_limits<Number>::infinity()), high(-low);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                Number& least = low[static_cast<glm::length_t>(axis)];
                Number& most = high[static_cast<glm::length_t>(axis)];
                least = std::min(least, below.low[axis][lane]);
                most = std::max(most, below.high[axis][lane]);
            }
        put(groups_[levels_[level].first + i / arity], i % arity, low, high);
    }

    std::vector<FourBoxes<Number>> groups_; ///< level by level
    std::vector<Level> levels_;             ///< items' boxes come first
};

} // namespace edgeshade
