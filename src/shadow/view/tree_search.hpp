#pragma once

#include "src/shadow/geometry/box_tree.hpp"
#include "src/shadow/view/bound_test.hpp"

#include <algorithm>
#include <array>

namespace edgeshade {

/// One bit for each side of the frustum that boxes may be outside of.
using SideBits = unsigned;
inline constexpr SideBits allSides = 0b11111;

/// A box of a tree that may hold surfaces which extend a bound.
struct Candidate {
    std::size_t level, number;
    double beyond, value; ///< of BoundTest::Reach, when it was found
    SideBits sides;       ///< those that it may be outside of
};

/// Candidates among boxes side by side, the most promising last.
struct Candidates {
    std::array<Candidate, 4> all;
    std::size_t count = 0;

    void insert(const Candidate& candidate) {
        std::size_t at = count++;
        for (; at > 0 && all[at - 1].value > candidate.value; --at)
            all[at] = all[at - 1];
        all[at] = candidate;
    }
};

/// Where boxes side by side lie in the frustum.
struct InFrustum {
    std::array<bool, 4> outside{};   ///< certainly outside some side
    std::array<SideBits, 4> sides{}; ///< those that the box may be outside of, in part
};

template <class Number>
InFrustum inFrustum(const FourBoxes<Number>& boxes, const SpaceInView& space, SideBits sides) {
    InFrustum in;
    for (std::size_t s = 0; s < 5; ++s) {
        if ((sides >> s & 1u) == 0) continue;
        const std::array<double, 4> inmost = largestOf(space.side(s), boxes);
        const std::array<double, 4> outmost = largestOf(-space.side(s), boxes);
        for (std::size_t i = 0; i < 4; ++i) {
            in.outside[i] = in.outside[i] || inmost[i] < 0.0;
            if (!(outmost[i] <= 0.0)) in.sides[i] |= 1u << s;
        }
    }
    return in;
}

/// Calls visit(item, sides) for items that may hold surfaces which extend a bound, the most
/// promising first, until it returns false. It makes `test` follow its findings.
/// `isHidden(level, group, lane)`: no surface in that box counts.
template <class Number, class IsHidden, class Visit>
void search(const BoxTree<Number>& tree, const SpaceInView& space, const BoundTest& test,
            SideBits sides, const IsHidden& isHidden, const Visit& visit) {
    if (tree.levels() == 0) return;
    // Every level leaves at most three boxes waiting.
    std::array<Candidate, 3 * BoxTree<Number>::mostLevels + 1> waiting;
    std::size_t count = 0;
    const auto open = [&](std::size_t level, std::size_t group, SideBits of) {
        const FourBoxes<Number>& boxes = tree.group(level, group);
        const BoundTest::Reach reach = test.reachOf(boxes);
        const InFrustum in = inFrustum(boxes, space, of);
        const std::size_t lanes = std::min<std::size_t>(4, tree.count(level) - 4 * group);
        Candidates found;
        for (std::size_t i = 0; i < lanes; ++i)
            if (!in.outside[i] && test.mayExtend(reach.beyond[i]) && !isHidden(level, group, i))
                found.insert({level, 4 * group + i, reach.beyond[i], reach.value[i], in.sides[i]});
        for (std::size_t i = 0; i < found.count; ++i)
            waiting[count++] = found.all[i];
    };
    open(tree.levels() - 1, 0, sides);
    while (count > 0) {
        const Candidate box = waiting[--count];
        if (!test.mayExtend(box.beyond)) continue;
        if (box.level > 0)
            open(box.level - 1, box.number, box.sides);
        else if (!visit(box.number, box.sides))
            return;
    }
}

} // namespace edgeshade
