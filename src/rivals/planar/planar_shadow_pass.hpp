#pragma once

#include "src/gl/program.hpp"
#include "src/rivals/planar/shadow_planes.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <map>

namespace edgeshade {

/// Shadows of all casters on a scene's ShadowPlanes, and on nothing else (Sambeek 2007): casters
/// are projected by the light onto each plane, which is exact there. Every pixel is dark once or
/// not at all, since the stencil says so.
class PlanarShadowPass {
  public:
    /// What is drawn for one light.
    struct Target {
        const GpuScene& scene;
        const FrameView& view;
        const DepthSlice& slice;
        const Light& light;
    };

    PlanarShadowPass();

    /// Marks what of the planes' surfaces in the depth buffer is in the light's shadow: the
    /// stencil, which must be 0, is not 0 there, also where casters in a plane are seen from the
    /// side that is turned away from the light. Colour and depth masks are the caller's state, the
    /// viewport the picture's. Leaves the depth test on and LESS, the stencil's test on. Returns
    /// vertex runs.
    std::size_t mark(const Target& target, const ShadowPlanes& planes);

  private:
    struct Variant {
        bool clipped, alphaTest;

        auto operator<=>(const Variant&) const = default;
    };
    /// In use.
    const gl::Program& program(const Variant& variant);
    void markReceivers(const Target& target, const ShadowPlane& plane, unsigned planeBit);
    void projectCasters(const Target& target, const ShadowPlane& plane, unsigned planeBit);
    void projectChunk(const Target& target, const ShadowPlane& plane, const SurfaceChunk& chunk,
                      const glm::dmat4& worldFromBatch, const glm::mat4& clipFromObject);

    std::map<Variant, gl::Program> programs_;
    gl::Program receivers_;
    std::size_t vertexRuns_ = 0;
};

} // namespace edgeshade
