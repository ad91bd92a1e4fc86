#pragma once

#include "src/shadow/view/frame_view.hpp"

#include <cstddef>
#include <optional>

namespace edgeshade {

/// Marks lights that reach no visible geometry as not drawn: they are not planned, drawn or
/// uploaded, and the picture is the same. Lights with an extent stay.
void leaveOutUnreached(FrameView& view);

/// Estimate of a light's contribution to the picture: its brightness over the squared distance to
/// the visible geometry, times the share of the picture that it reaches. No unit; 0 if it reaches
/// nothing. A light that isn't in candela counts with an even share of the picture's light.
double importanceOf(const FrameView& view, const Light& light);

/// Makes the light ignore casters, and shine from its centre alone.
void leaveWithoutShadow(FrameLight& light);

/// Keeps shadows only for the `most` most important lights, by importanceOf(); of equal ones the
/// first.
void keepShadowed(FrameView& view, std::size_t most);

/// Calls both; `mostShadowed`: null if all lights have shadows.
void chooseLights(FrameView& view, std::optional<std::size_t> mostShadowed);

} // namespace edgeshade
