#include "src/shadow/geometry/outline_grid.hpp"

namespace edgeshade {
namespace {

int place(double share) {
    return static_cast<int>(std::clamp(share * OutlineGrid::side, 0.0, OutlineGrid::side - 1.0));
}

} // namespace

OutlineGrid::OutlineGrid(const Outline& part, std::span<const Outline> outlines)
    : part_(part), counts_((side + 1) * (side + 1), 0) {
    // Each outline adds to its four corners; the sums from the first corner are the counts.
    for (const Outline& outline : outlines) {
        const auto range = rangeOf(outline);
        if (!range) continue;
        at(range->i0, range->j0) += 1;
        at(range->i1 + 1, range->j0) -= 1;
        at(range->i0, range->j1 + 1) -= 1;
        at(range->i1 + 1, range->j1 + 1) += 1;
    }
    for (int j = 0; j <= side; ++j)
        for (int i = 1; i <= side; ++i)
            at(i, j) += at(i - 1, j);
    for (int j = 1; j <= side; ++j)
        for (int i = 0; i <= side; ++i)
            at(i, j) += at(i, j - 1);
}

std::optional<OutlineGrid::Range> OutlineGrid::rangeOf(const Outline& outline) const {
    if (outline.misses(part_)) return std::nullopt;
    const double across = part_.u1 - part_.u0, along = part_.v1 - part_.v0;
    return Range{place((outline.u0 - part_.u0) / across), place((outline.u1 - part_.u0) / across),
                 place((outline.v0 - part_.v0) / along), place((outline.v1 - part_.v0) / along)};
}

std::size_t OutlineGrid::largestCount() const {
    return static_cast<std::size_t>(*std::max_element(counts_.begin(), counts_.end()));
}

Outline OutlineGrid::cell(int i, int j) const {
    const double across = part_.u1 - part_.u0, along = part_.v1 - part_.v0;
    return {part_.u0 + across * i / side, part_.u0 + across * (i + 1) / side,
            part_.v0 + along * j / side, part_.v0 + along * (j + 1) / side};
}

Outline reachedPart(const Outline& whole, std::span<const Outline> outlines) {
    Outline all;
    for (const Outline& outline : outlines) {
        if (outline.misses(whole)) continue;
        all.u0 = std::min(all.u0, outline.u0);
        all.u1 = std::max(all.u1, outline.u1);
        all.v0 = std::min(all.v0, outline.v0);
        all.v1 = std::max(all.v1, outline.v1);
    }
    return {std::max(whole.u0, all.u0), std::min(whole.u1, all.u1), std::max(whole.v0, all.v0),
            std::min(whole.v1, all.v1)};
}

} // namespace edgeshade
