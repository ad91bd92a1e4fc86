#pragma once

#include "src/lab/exact_judge.hpp"

namespace edgeshade::lab {

/// The coarsest grid that GLES 2 lets a device put vertices on (SUBPIXEL_BITS >= 4), in pixels.
inline constexpr double coarsestGrid = 1.0 / 16.0;

/// Whether the exact answer at a pixel's centre hangs on less than `grid` pixels, which are those
/// of a device that puts vertices on such a grid, or of any at coarsestGrid:
/// * surfaces coincide there;
/// * the answer changes as the ray is moved by `grid` in one of eight directions;
/// * a silhouette passes within `grid`: the eye's, where the visible surface ends and is not joined
///   by an edge to what follows, or the light's, where a shadow volume's side touches the surface
///   that it begins on;
/// * another surface, hidden by less than the two change in depth over `grid`, has another answer;
/// * the answer changes as the visible surface is moved in depth by no more than its own depth
///   changes over `grid`, or as its corners are moved that far (it turns over to the light);
/// * the texture filter may decide whether there is a cutout (AlphaLookup::range), whatever the
/// grid.
bool isTie(const Oracle& oracle, int x, int y, const Verdict& verdict, double grid);

} // namespace edgeshade::lab
