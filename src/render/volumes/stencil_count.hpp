#pragma once

#include "src/render/drawing/whole_picture.hpp"
#include "src/shadow/plan/stencil_start.hpp"

namespace edgeshade {

/// The stencil's part in counting volumes, modulo 256. A volume counts where it begins before a
/// surface and ends behind it: by what of it is behind the surface (z-fail), or before it (z-pass).
/// Volumes' triangles are seen counter-clockwise from outside; a mirroring transform turns every
/// winding over. No faces are culled: which way a thin triangle faces is for the rasteriser to say,
/// once.

/// What glClear() makes of the stencil from now on: everywhere what the count starts from.
void setStencilClear(const StencilStart& start);

/// Clears the stencil to that; by itself to 0.
void clearStencil(const StencilStart& start = {});

/// Triangles that are drawn from now on count by one.
void countByOne(bool zFail, bool mirrored);

/// Turns the counts c that began at start.cleared() into 2 c, or 2 c + 1 where the start is odd,
/// modulo 256, as if they had begun at start.count() and gone by two. GLES 2 steps by ones alone,
/// so the bits move up one by one, a pass each. `picture` is what the passes draw. Expects nothing
/// but the stencil to be written, tested always; leaves that so.
void doubleCounts(const StencilStart& start, const WholePicture& picture);

} // namespace edgeshade
