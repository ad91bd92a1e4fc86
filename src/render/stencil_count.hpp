#pragma once

#include "src/render/whole_picture.hpp"

namespace edgeshade {

/// The stencil's part in counting volumes, modulo 256. A volume counts where it begins before a
/// surface and ends behind it: by what of it is behind the surface (z-fail), or before it (z-pass).
/// Volumes' triangles are seen counter-clockwise from outside; a mirroring transform turns every
/// winding over. No faces are culled: which way a thin triangle faces is for the rasteriser to say,
/// once.

/// Everywhere the same count.
void clearStencil(int count);

/// Triangles that are drawn from now on count by one.
void countByOne(bool zFail, bool mirrored);

/// What the stencil is cleared to where some of what counts from `start` counts by two: that is
/// drawn first and counts by one, then all counts are doubled.
int halvedStart(int start);

/// Turns the counts c that began at halvedStart(start) into 2 c, or 2 c + 1 where `start` is odd,
/// modulo 256, as if they had begun at `start` and gone by two. GLES 2 steps by ones alone, so the
/// bits move up one by one, a pass each. `picture` is what the passes draw. Expects nothing but
/// the stencil to be written, tested always; leaves that so.
void doubleCounts(int start, WholePicture& picture);

} // namespace edgeshade
