#pragma once

#include "src/render/drawing/whole_picture.hpp"
#include "src/shadow/plan/stencil_start.hpp"

namespace edgeshade {

/// Stencil operations that count volumes, modulo 256. A volume counts if it begins before a surface
/// and ends behind it; its faces are counted behind the surface (z-fail) or before it (z-pass).
/// Seen from outside, volumes' triangles are counter-clockwise; a mirroring transform reverses
/// every winding. No faces are culled: only the rasteriser decides which way a thin triangle faces,
/// and it does so once.

/// Makes later calls of glClear() set the whole stencil to the value that counting starts at.
void setStencilClear(const StencilStart& start);

/// Clears the stencil to `start`, by default to 0.
void clearStencil(const StencilStart& start = {});

/// Makes triangles that are drawn next count by one.
void countByOne(bool zFail, bool mirrored);

/// Turns the counts c that began at start.cleared() into 2 c, or 2 c + 1 if the start is odd,
/// modulo 256, as if they had begun at start.count() and changed by two. GLES 2 steps only by one,
/// so each pass moves one bit up. `picture` is what the passes draw. Expects that only the stencil
/// is written and its function is ALWAYS; leaves that state.
void doubleCounts(const StencilStart& start, const WholePicture& picture);

} // namespace edgeshade
