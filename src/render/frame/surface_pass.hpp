#pragma once

#include "src/gl/program_variants.hpp"
#include "src/render/frame/surface_variant.hpp"

namespace edgeshade {

/// Whether all surfaces of a batch are certainly outside one of the planes, viewPlanes() of the
/// world.
bool isOutOfView(const GpuBatch& batch, const ViewPlanes& planes);

/// The camera's view of a batch, and its placement in the light's map.
BatchView surfaceViewOf(const GpuScene& scene, const GpuBatch& batch, const FrameView& view,
                        const DepthSlice& slice, const SurfaceShading& shading);

/// Draws visible surfaces, from both sides unless the scene culls single-sided ones. Depth, stencil
/// and blending are the caller's state. Surfaces with unlit materials have their own colour in any
/// light; in masks they show shadows like others.
class SurfacePass {
  public:
    explicit SurfacePass(const gl::Capabilities& capabilities)
        : device_{capabilities.textureUnits, capabilities.has("GL_OES_standard_derivatives")} {}

    /// Draws the batch's opaque surfaces, then its alpha-tested ones, in the order of its chunks.
    /// Returns vertex runs.
    std::size_t draw(const GpuScene& scene, const GpuBatch& batch, const BatchView& view,
                     const SurfaceShading& shading);

    /// Draws one chunk, limited to the sides that the caller doesn't cull, unless it is certainly
    /// outside the view. Returns vertex runs.
    std::size_t drawChunk(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                          const SurfaceShading& shading);

    /// Begins to make a program ahead of draw().
    void beginProgram(const SurfaceVariant& variant) { program(variant); }
    void forEachProgram(const gl::ProgramVisitor& visit) const { programs_.forEachProgram(visit); }

  private:
    std::size_t drawSeen(const GpuScene& scene, const SurfaceChunk& chunk, const BatchView& view,
                         const SurfaceShading& shading);
    const gl::Program& program(const SurfaceVariant& variant);

    SurfaceDevice device_;
    gl::ProgramVariants<SurfaceVariant> programs_;
};

} // namespace edgeshade
