#pragma once

#include "src/render/technique/caster_group.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/plan/count_plan.hpp"

namespace edgeshade {

/// Colours that debug views draw volumes in.
struct VolumeTints {
    glm::vec4 before; ///< sides counted once before surfaces (z-pass)
    glm::vec4 behind; ///< sides counted once behind them (z-fail)
    glm::vec4 twice;  ///< sides counted twice
    glm::vec4 caps;   ///< and fans

    const glm::vec4& of(const VolumeDraw& draw) const;
};

/// A batch, as a draw needs it.
struct DrawnBatch {
    const GpuScene* scene; ///< whose materials say where casters are alpha-tested
    const BatchVolumes& volumes;
    const BatchPlan& plan;
    glm::mat4 clipFromObject;
    bool mirrored = false;
};

/// Plans and draws shadow volumes from one layout of records. Each frame: beginFrame(); plan();
/// prepare() with what is planned; then draw(), which changes nothing but what the GL draws.
class VolumeRenderer {
  public:
    virtual ~VolumeRenderer() = default;

    /// Lights move from frame to frame, never within one.
    virtual void beginFrame(const GpuScene&) {}

    /// What is drawn of the casters, into the plan of others, whose memory it may reuse. Uploads
    /// nothing.
    virtual void plan(const GpuScene& scene, const CasterGroupInSlice& casters,
                      CountPlan& plan) = 0;

    /// Uploads the records that the plan's draws take, and makes their programs, where they are not
    /// there yet.
    virtual void prepare(const CountPlan& plan, GpuScene& scene,
                         const CasterGroupInSlice& casters) = 0;

    /// What it does to the stencil and the picture is the caller's state.
    virtual void draw(const VolumeDraw& draw, const DrawnBatch& batch) const = 0;

    /// Which of a batch's shadow data it draws from.
    virtual VolumeLayout layout() const = 0;

    /// The lists that are kept for the lights of late; null where none are.
    virtual const PotentialSilhouettes* silhouettes() const { return nullptr; }

    // Memory on the GPU beyond the scene's:
    virtual std::size_t sideBytes() const { return 0; }
    virtual std::size_t capBytes() const { return 0; }
    std::size_t bytes() const { return sideBytes() + capBytes(); }
};

} // namespace edgeshade
