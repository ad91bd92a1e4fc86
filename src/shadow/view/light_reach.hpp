#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// The pixels with visible surfaces. Conservative by a pixel; the whole picture if the visible
/// geometry is unknown.
PixelRectangle visiblePixels(const FrameView& view);

/// The pixels that a light can reach in a slice of the view: those around its cone, and around the
/// part of its ball between the slice's near plane and the farthest visible depth there.
/// Conservative by a pixel; may be empty; the whole picture for a light without a range and without
/// a cone.
PixelRectangle lightReach(const FrameView& view, const DepthSlice& slice, const Light& light);

/// The pixels on which casters within a box in the world may shadow visible geometry. Conservative
/// by a pixel; the whole picture if the visible geometry is unknown, or the light is in the box;
/// empty for an empty box.
PixelRectangle shadowReach(const FrameView& view, const Box& casters, const Light& light);

/// The same rectangle in a picture of `size` that shows the same view: whole pixels, with a margin
/// of two.
PixelRectangle scaledReach(const PixelRectangle& reach, const FrameView& view,
                           const glm::ivec2& size);

} // namespace edgeshade
