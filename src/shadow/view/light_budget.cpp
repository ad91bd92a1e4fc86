#include "src/shadow/view/light_budget.hpp"

#include "src/shadow/view/light_reach.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <vector>

namespace edgeshade {
namespace {

/// Shortest distance that counts, as a share of the light's range, or of the visible geometry's
/// size. Otherwise a light among the visible geometry would be infinitely bright.
constexpr double leastDistance = 0.25;

/// Number of pixels that the light reaches, over all depths.
double areaOf(const FrameView& view, const Light& light) {
    PixelRectangle reach;
    for (const DepthSlice& slice : view.slices)
        reach = united(reach, lightReach(view, slice, light));
    reach = intersection(reach, visiblePixels(view));
    return reach.empty() ? 0.0 : static_cast<double>(reach.width) * reach.height;
}

} // namespace

void leaveOutUnreached(FrameView& view) {
    for (FrameLight& of : view.lights) {
        if (of.light.extent || !of.points.empty()) continue;
        const bool reaches =
            std::any_of(view.slices.begin(), view.slices.end(), [&](const DepthSlice& slice) {
                return !lightReach(view, slice, of.light).empty();
            });
        of.drawn = of.drawn && reaches;
    }
}

double importanceOf(const FrameView& view, const Light& light) {
    const double share = areaOf(view, light) / (static_cast<double>(view.width) * view.height);
    const glm::dvec3 color(light.color); // luminance, CIE's Y
    const double bright = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
    if (!light.photometric) return bright * share / static_cast<double>(view.lights.size());
    const double reflected = bright * std::numbers::inv_pi * share;
    if (light.position.w == 0.0) return reflected;
    const double size = view.visible.empty() ? view.bounds.diagonal() : view.visible.diagonal();
    const double least = leastDistance * (light.hasRange() ? std::min(light.range, size) : size);
    const double distance = std::max(view.visible.distanceTo(glm::dvec3(light.position)), least);
    return distance > 0.0 ? reflected / (distance * distance) : reflected;
}

void leaveWithoutShadow(FrameLight& light) {
    light.shadowed = false;
    light.points.clear();
    light.light.extent.reset();
    light.cut.reset();
    light.layers = {};
}

void keepShadowed(FrameView& view, std::size_t most) {
    std::vector<std::size_t> order(view.lights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> importance;
    for (const FrameLight& of : view.lights)
        importance.push_back(of.drawn ? importanceOf(view, of.light) : 0.0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return importance[a] > importance[b]; });
    for (std::size_t i = most; i < order.size(); ++i)
        leaveWithoutShadow(view.lights[order[i]]);
}

void chooseLights(FrameView& view, std::optional<std::size_t> mostShadowed) {
    leaveOutUnreached(view);
    if (mostShadowed) keepShadowed(view, *mostShadowed);
}

} // namespace edgeshade
