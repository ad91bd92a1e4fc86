#pragma once

#include "src/lab/oracle.hpp"

#include <optional>

namespace edgeshade::lab {

/// An answer in rational arithmetic, and whether it is degenerate.
struct Verdict {
    Answer answer;
    bool coincident = false; ///< two surfaces at exactly the same depth, or a light in the plane
};

/// The first surface on a line of sight.
struct ExactSurface {
    std::uint32_t triangle = 0; ///< of surfaces at one depth the first
    double depth = 0.0;         ///< rounded once
    bool coincident = false;    ///< another surface is at exactly the same depth
};

/// The surface that a picture point shows, without rounding; null: none.
std::optional<ExactSurface> surfaceExactly(const Oracle& oracle, double x, double y);

/// The answer at a picture point without rounding: the triangles relative to the eye and the ray
/// are taken as the doubles that they are. Used for the few pixels where the oracle and a picture
/// disagree; takes about a millisecond each.
Verdict judgeExactly(const Oracle& oracle, double x, double y);

/// The answer at a pixel's centre, exact unless rounding can't have changed it. `pixel`: rows top
/// to bottom.
Verdict judge(const Oracle& oracle, std::size_t pixel);

} // namespace edgeshade::lab
