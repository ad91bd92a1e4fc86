#include "src/shadow/view/reached_part.hpp"

#include "src/shadow/lights/light_range.hpp"
#include "src/shadow/view/light_reach.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// Pixels of margin around the reach: masks of lower resolution are counted up to two of their
/// pixels beyond it (scaledReach()), each up to four wide.
constexpr int margin = 16;

PixelRectangle widened(const PixelRectangle& reach, const FrameView& view) {
    return intersection(
        {reach.x - margin, reach.y - margin, reach.width + 2 * margin, reach.height + 2 * margin},
        {0, 0, view.width, view.height});
}

} // namespace

void findReachedPart(const FrameView& view, const DepthSlice& slice, const Light& light,
                     FrameView& part) {
    part.clear();
    part.frustum = view.frustum;
    part.width = view.width;
    part.height = view.height;
    part.bounds = view.bounds;
    part.slices = view.slices;
    part.farPlane = view.farPlane;
    part.farthestDepth = view.farthestDepth;
    part.visible = view.visible;
    part.slopes = view.slopes;
    part.culls = view.culls;
    if (!light.hasRange() && !light.isSpot()) return;
    const PixelRectangle pixels = widened(lightReach(view, slice, light), view);
    if (pixels.empty()) return;
    const glm::dvec2 size(view.width, view.height);
    const glm::dvec2 low(pixels.x, pixels.y);
    const glm::dvec2 high = low + glm::dvec2(pixels.width, pixels.height);
    part.frustum.low = view.frustum.low + view.frustum.size() * (low / size);
    part.frustum.high = view.frustum.low + view.frustum.size() * (high / size);
    if (!light.hasRange()) return;
    const double range = rangeWidening * light.range;
    const glm::dvec3 center(light.position);
    part.farthestDepth = std::min(view.farthestDepth, depthOf(view.frustum, center) + range);
    if (!view.visible.empty()) {
        part.visible.low = glm::max(view.visible.low, center - range);
        part.visible.high = glm::min(view.visible.high, center + range);
    }
}

} // namespace edgeshade
