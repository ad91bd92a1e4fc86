#pragma once

#include "src/gl/program.hpp"
#include "src/render/technique/caster_group.hpp"
#include "src/scene/gpu_scene.hpp"
#include "src/shadow/plan/count_plan.hpp"

#include <optional>

namespace edgeshade {

/// Colours of volumes in debug views.
struct VolumeTints {
    glm::vec4 before; ///< sides counted once before surfaces (z-pass)
    glm::vec4 behind; ///< sides counted once behind surfaces (z-fail)
    glm::vec4 twice;  ///< sides counted twice
    glm::vec4 caps;   ///< caps and fans

    const glm::vec4& of(const VolumeDraw& draw) const;
};

/// A batch with the data that a draw needs.
struct DrawnBatch {
    const GpuScene* scene; ///< its materials say where casters are alpha-tested
    const BatchVolumes& volumes;
    const BatchPlan& plan;
    glm::mat4 clipFromObject;
    bool mirrored = false;
};

/// The #defines of shaders that draw in a tint; none without.
std::vector<std::string> tintDefines(const std::optional<VolumeTints>& tints);

/// Sets what all programs for volumes, of which this one is in use, need of a draw.
void setVolume(const gl::Program& program, const VolumeDraw& draw, const DrawnBatch& batch,
               const std::optional<VolumeTints>& tints);

/// Plans and draws shadow volumes from one layout of records. In each frame: beginFrame(); plan();
/// prepare() with the plan; then draw(), which only issues GL draws.
class VolumeRenderer {
  public:
    virtual ~VolumeRenderer() = default;

    /// Lights move from frame to frame, never within one. `mostListed`: as of
    /// PotentialSilhouettes::beginFrame().
    virtual void beginFrame(const GpuScene&, [[maybe_unused]] std::size_t mostListed) {}

    /// Plans the draws for the casters, into an earlier plan, whose memory it may reuse. Uploads
    /// nothing.
    virtual void plan(const GpuScene& scene, const CasterGroupInSlice& casters,
                      CountPlan& plan) = 0;

    /// Uploads the records that the plan draws, and makes its programs, if they are missing.
    virtual void prepare(const CountPlan& plan, GpuScene& scene,
                         const CasterGroupInSlice& casters) = 0;

    /// Draws. The caller's state decides the effect on the stencil and the picture.
    virtual void draw(const VolumeDraw& draw, const DrawnBatch& batch) const = 0;

    /// Begins to make, ahead of prepare(), programs that most closed casters take; `directional`:
    /// of directional lights, too; `open`: those of open casters, too.
    virtual void beginPrograms([[maybe_unused]] bool directional, [[maybe_unused]] bool open) {}
    virtual void forEachProgram([[maybe_unused]] const gl::ProgramVisitor& visit) const {}

    /// The layout of the shadow data that it draws from.
    virtual VolumeLayout layout() const = 0;

    /// The lists kept for recent lights; null if it keeps none.
    virtual const PotentialSilhouettes* silhouettes() const { return nullptr; }

    // Memory on the GPU beyond the scene's:
    virtual std::size_t sideBytes() const { return 0; }
    virtual std::size_t capBytes() const { return 0; }
    std::size_t bytes() const { return sideBytes() + capBytes(); }
};

} // namespace edgeshade
