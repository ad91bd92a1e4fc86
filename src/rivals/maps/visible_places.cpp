#include "src/rivals/maps/visible_places.hpp"

#include "src/gl/framebuffer_keeper.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr double mostPixels = 16384.0;
constexpr double largestNearness = 16777215.0; // see shaders_es2/nearness.glsl

/// The same view with at most mostPixels pixels.
FrameView coarse(FrameView view) {
    const double scale = std::max(1.0, std::sqrt(view.width * (view.height / mostPixels)));
    view.width = std::max(1, static_cast<int>(view.width / scale));
    view.height = std::max(1, static_cast<int>(view.height / scale));
    return view;
}

} // namespace

std::vector<glm::dvec3>
VisiblePlaces::find(const FrameView& of,
                    const std::function<void(const FrameView&)>& drawNearness) {
    const FrameView view = coarse(of);
    std::vector<std::uint8_t> pixels(std::size_t{4} * static_cast<std::size_t>(view.width) *
                                     static_cast<std::size_t>(view.height));
    {
        const gl::FramebufferKeeper keeper;
        target_.bind(view.width, view.height);
        drawNearness(view);
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    }
    const glm::dmat4 worldFromView = glm::inverse(view.frustum.viewFromWorld);
    std::vector<glm::dvec3> places;
    const std::uint8_t* pixel = pixels.data();
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x, pixel += 4) {
            const double nearness = (65536.0 * pixel[0] + 256.0 * pixel[1] + pixel[2]);
            if (pixel[3] == 0 || nearness == 0.0) continue;
            const bool flat = view.frustum.orthographic;
            const double depth = flat ? view.near() + (1.0 - nearness / largestNearness) *
                                                          (view.farPlane - view.near())
                                      : view.near() * largestNearness / nearness;
            const glm::dvec2 point(2.0 * (x + 0.5) / view.width - 1.0,
                                   2.0 * (y + 0.5) / view.height - 1.0);
            const glm::dvec2 window = view.frustum.windowAt(point) * (flat ? 1.0 : depth);
            places.emplace_back(worldFromView * glm::dvec4(window, -depth, 1.0));
        }
    return places;
}

} // namespace edgeshade
