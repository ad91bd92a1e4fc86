#pragma once

#include "src/gl/program_variants.hpp"
#include "src/rivals/planar/shadow_planes.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/view/frame_view.hpp"

namespace edgeshade {

/// Shadows of all casters on a scene's ShadowPlanes, and on nothing else (Sambeek 2007). Casters
/// are projected from the light onto each plane, where the result is exact. The stencil ensures
/// that every pixel is darkened at most once.
class PlanarShadowPass {
  public:
    /// The scene, view and light to draw shadows for.
    struct Target {
        const GpuScene& scene;
        const FrameView& view;
        const DepthSlice& slice;
        const Light& light;
    };

    PlanarShadowPass();

    /// Marks the light's shadow on the planes' surfaces in the depth buffer: the stencil, which
    /// must be 0, is not 0 there. Casters in a plane that are seen from the side facing away from
    /// the light are marked, too. Colour and depth masks are the caller's state, and so is the
    /// viewport (the picture's). Leaves the depth test on and LESS, and the stencil test on.
    /// Returns vertex runs.
    std::size_t mark(const Target& target, const ShadowPlanes& planes);

  private:
    struct Variant {
        bool clipped, alphaTest;

        auto operator<=>(const Variant&) const = default;
    };
    /// Returns the program, in use.
    const gl::Program& program(const Variant& variant);
    void markReceivers(const Target& target, const ShadowPlane& plane, unsigned planeBit);
    void projectCasters(const Target& target, const ShadowPlane& plane, unsigned planeBit);
    void projectChunk(const Target& target, const ShadowPlane& plane, const SurfaceChunk& chunk,
                      const glm::dmat4& worldFromBatch, const glm::mat4& clipFromObject);

    gl::ProgramVariants<Variant> programs_;
    gl::Program receivers_;
    std::size_t vertexRuns_ = 0;
};

} // namespace edgeshade
