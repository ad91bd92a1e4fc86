#pragma once

#include "src/lab/oracle.hpp"

namespace edgeshade::lab {

/// An answer in rational arithmetic, and whether it hangs on a hair.
struct Verdict {
    Answer answer;
    bool coincident = false; ///< two surfaces at the very same depth, or a light in the plane
};

/// The answer at a picture point without rounding: triangles relative to the eye and the ray are
/// taken as the doubles that they are. For the few pixels that the oracle and a picture disagree
/// on; about a millisecond each.
Verdict judgeExactly(const Oracle& oracle, double x, double y);

} // namespace edgeshade::lab
