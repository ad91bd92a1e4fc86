#pragma once

#include "src/gl/headless_context.hpp"
#include "src/render/frame/frame.hpp"

namespace edgeshade::test {

/// Environment variable for the repeated run of image tests: es2-minimum.
inline constexpr const char* limitsVariable = "EDGESHADE_TEST_GL_LIMITS";

/// The limits that the environment sets.
gl::Limits testLimits();

/// Whether a processor draws instead of hardware: depths of triangles in one plane are equal then.
bool drawsOnProcessor();

/// Whether shaders have derivatives, as masks of lower resolution need; not with the least that ES
/// 2.0 guarantees.
bool hasDerivatives();

/// Whether visible points can be tested one by one.
bool canAskPoints();

/// A picture for tests, with the environment's limits.
gl::HeadlessContext::Request testPicture(int width, int height, int samples = 0);

/// The view that a test draws.
struct TestView {
    Camera camera;
    std::vector<Light> lights;
    int width = 64;
    int height = 64;
    bool mask = false;
    DepthChoice depth{};
    std::optional<std::vector<std::size_t>> drawnLights = {}; ///< indices; empty: all of them
    bool nearDiscard = true;          ///< false: front caps are never cut, which is a fault
    std::optional<Frustum> frustum{}; ///< in place of the camera's
    SceneImages images{};             ///< for the materials' textures
    bool culledCaps = true; ///< false: culled casters count as if they were visible, which is a
                            ///< fault

    /// The frustum in use.
    Frustum seen() const {
        return frustum.value_or(frustumOf(camera, static_cast<double>(width) / height));
    }
};

/// A picture of the scene, RGBA rows top to bottom, drawn in its own context. A context of the
/// caller is no longer current then.
std::vector<std::uint8_t> drawScene(const Scene& scene, const TestView& view,
                                    RenderSettings settings, bool castMasked = false);

inline Light pointLight(const glm::dvec3& position) {
    return {glm::dvec4(position, 1.0)};
}
inline Light sun(const glm::dvec3& towards) {
    return {glm::dvec4(towards, 0.0)};
}

} // namespace edgeshade::test
