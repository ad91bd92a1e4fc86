#pragma once

#include "src/shadow/view/frame_view.hpp"

#include <cstddef>
#include <optional>

namespace edgeshade {

/// Marks the lights that reach nothing of what is visible as not drawn: nothing is planned, drawn
/// or uploaded for them, and nothing of the picture changes. Those with an extent stay.
void leaveOutUnreached(FrameView& view);

/// How much a light is estimated to add to the picture: how bright it is over the square of how far
/// it is from what is visible, times the share of the picture that it reaches. No unit; 0 where it
/// reaches nothing. A light without candela counts as one of an even share of the picture's light.
double importanceOf(const FrameView& view, const Light& light);

/// Has it shine through what casts, from its centre alone.
void leaveWithoutShadow(FrameLight& light);

/// Leaves shadows to the lights that matter most, `most` of them, by importanceOf(); of equal ones
/// to the first.
void keepShadowed(FrameView& view, std::size_t most);

/// Both; `mostShadowed`: nothing where all lights are to have shadows.
void chooseLights(FrameView& view, std::optional<std::size_t> mostShadowed);

} // namespace edgeshade
