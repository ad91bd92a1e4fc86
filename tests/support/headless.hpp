#pragma once

#include "src/render/frame.hpp"

namespace edgeshade::test {

/// A picture of the scene, RGBA rows top to bottom, drawn by a context of its own. The near plane
/// is fitted where view.near is 0, and so are the nearest depths where there are none.
std::vector<std::uint8_t> drawScene(const Scene& scene, FrameView view, RenderSettings settings,
                                    bool castMasked = false);

/// A view of the given size with one light.
FrameView viewOf(const Camera& camera, const Light& light, int width, int height);

inline Light pointLight(const glm::dvec3& position) {
    return {glm::dvec4(position, 1.0)};
}
inline Light sun(const glm::dvec3& towards) {
    return {glm::dvec4(towards, 0.0)};
}

} // namespace edgeshade::test
