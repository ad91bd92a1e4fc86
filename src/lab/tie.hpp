#pragma once

#include "src/lab/exact_judge.hpp"

namespace edgeshade::lab {

/// The coarsest grid, in pixels, on which GLES 2 lets a device place vertices (SUBPIXEL_BITS >= 4).
inline constexpr double coarsestGrid = 1.0 / 16.0;

/// Whether the exact answer at a pixel's centre depends on less than `grid` pixels. `pixel`: rows
/// top to bottom. `grid` is that of the device's vertices, or coarsestGrid for any device. It does
/// if:
/// * surfaces coincide there;
/// * the answer changes as the ray moves by `grid` in one of eight directions;
/// * a silhouette passes within `grid`: the eye's, where the visible surface ends and is not joined
///   by an edge to what follows, or the light's, where a shadow volume's side touches the surface
///   that it begins on;
/// * another surface, hidden by less than both change in depth over `grid`, has another answer;
/// * the answer changes as the visible surface moves in depth by no more than its own depth changes
///   over `grid`, or as its corners move that far (its facing to the light changes);
/// * the texture filter may decide whether there is a cutout (AlphaLookup::range), whatever the
///   grid.
bool isTie(const Oracle& oracle, std::size_t pixel, const Verdict& verdict, double grid);

} // namespace edgeshade::lab
