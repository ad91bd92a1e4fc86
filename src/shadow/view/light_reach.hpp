#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// The pixels that surfaces are in. Conservative by a pixel; the whole picture where nothing is
/// known of what is visible.
PixelRectangle visiblePixels(const FrameView& view);

/// The pixels that a light can reach in a slice of the view: those around the part of its ball that
/// is between the slice's near plane and the farthest that is visible there, and around its cone.
/// Conservative by a pixel; empty where there is none; the whole picture for a light without a
/// range and without a cone.
PixelRectangle lightReach(const FrameView& view, const DepthSlice& slice, const Light& light);

/// The same rectangle in a picture of `size`, which shows what the view's does: whole pixels, and a
/// margin of two.
PixelRectangle scaledReach(const PixelRectangle& reach, const FrameView& view,
                           const glm::ivec2& size);

} // namespace edgeshade
