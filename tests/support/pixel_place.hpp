#pragma once

#include "src/shadow/geometry/pixel_rectangle.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade::test {

/// The place of a clip position in pixels from the lower left; empty outside the picture.
inline std::optional<glm::dvec2> placeInPicture(const glm::dvec4& clip, const FrameView& view) {
    const glm::dvec2 size(view.width, view.height);
    const glm::dvec2 place = (0.5 * glm::dvec2(clip) / clip.w + 0.5) * size;
    if (place.x < 0 || place.y < 0 || place.x > size.x || place.y > size.y) return std::nullopt;
    return place;
}

/// Whether the place is in the rectangle, including its edges.
inline bool holds(const PixelRectangle& pixels, const glm::dvec2& place) {
    return pixels.x <= place.x && place.x <= pixels.x + pixels.width && pixels.y <= place.y &&
           place.y <= pixels.y + pixels.height;
}

} // namespace edgeshade::test
