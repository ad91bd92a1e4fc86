#pragma once

#include "src/gl/capabilities.hpp"
#include "src/render/caps_pass.hpp"
#include "src/render/sides_pass.hpp"
#include "src/render/surface_pass.hpp"
#include "src/scene/camera.hpp"

#include <optional>

namespace edgeshade {

enum class ShadowMethod { volumes, none };

/// How frames are drawn; fixed for a renderer.
struct RenderSettings {
    ShadowMethod shadows = ShadowMethod::volumes;
    MultiplicityMethod multiplicity = MultiplicityMethod::referenceEdge;
    SidesLayout layout = SidesLayout::instanced;
    float ambient = 0.35f; ///< 0..1; the lights share the rest
    bool mask = false;     ///< the lit mask of the first light instead of a picture
    glm::vec3 background{0.86f, 0.89f, 0.92f};
};

/// What one frame shows.
struct FrameView {
    Camera camera;
    int width = 1;
    int height = 1;
    double near = 0.1;
    std::vector<double> nearestDepths; ///< of each batch, nearestVisibleDepth()
    std::vector<Light> lights;         ///< at least one
};

/// Draws frames by the three passes of the method (section 3): ambient light and depth; for each
/// light the shadow volumes into the stencil; then the lit surfaces, added.
///
/// Counts depth-fail crossings in an 8-bit wrapping stencil: more than 255 volumes around one
/// visible point would be miscounted. Draws into the current framebuffer, which needs a stencil.
class Renderer {
  public:
    /// Throws Error(unavailable) if the layout needs instancing and there is none.
    Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities);

    void draw(const GpuScene& scene, const FrameView& view);

  private:
    void drawDepthAndAmbient(const GpuScene& scene, const FrameView& view);
    void drawVolumes(const GpuScene& scene, const FrameView& view, const Light& light);
    void drawLit(const GpuScene& scene, const FrameView& view, const Light& light);
    void drawBlended(const GpuScene& scene, const FrameView& view);

    RenderSettings settings_;
    SurfacePass surfaces_;
    SidesPass sides_;
    CapsPass caps_;
};

/// The layout that suits the context: instanced where it can, else not.
SidesLayout bestLayout(const gl::Capabilities& capabilities);

} // namespace edgeshade
