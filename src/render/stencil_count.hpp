#pragma once

#include <functional>

namespace edgeshade {

/// The stencil's part in counting volumes, modulo 256. A volume counts where it begins before a
/// surface and ends behind it: by what of it is behind the surface (z-fail), or before it (z-pass).
/// Volumes' triangles are seen counter-clockwise from outside; a mirroring transform turns every
/// winding over.

/// Everywhere the same count.
void clearStencil(int count);

/// Triangles that are drawn from now on count by one.
void countByOne(bool zFail, bool mirrored);

/// What the stencil is cleared to for counting from `start` by two.
int clearedForTwo(int start);

/// Counts by two what `draw` draws, which must call countStepOfTwo(). It is called once for what
/// counts up and once for what counts down, as with the lowest bit held at 1 adding one carries
/// into the bits above, which alone are written, and held at 0 taking one borrows from them. The
/// stencil must have been cleared to clearedForTwo(start). Leaves all bits written, and no faces
/// culled.
void countByTwo(int start, const std::function<void(bool up)>& draw);

/// Of triangles that are drawn from now on those count that count in the given direction.
void countStepOfTwo(bool up, bool zFail, bool mirrored);

} // namespace edgeshade
