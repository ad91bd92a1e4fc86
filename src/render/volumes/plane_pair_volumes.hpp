#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/instancing.hpp"
#include "src/gl/program_variants.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/render/volumes/silhouette_buffers.hpp"
#include "src/render/volumes/volume_renderer.hpp"

#include <compare>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// Variants of the programs for plane-pair records.
struct PlanePairSidesVariant {
    bool pair = false; ///< records of two planes
    bool directional = false;
    bool cap = false; ///< fans of caps instead of sides

    auto operator<=>(const PlanePairSidesVariant&) const = default;
};

struct PlanePairCapsVariant {
    bool nearDiscard = false;
    bool alphaTest = false;
    bool culled = false; ///< front caps, in place, of casters that show their backs

    auto operator<=>(const PlanePairCapsVariant&) const = default;
};

/// Makes the programs. `extraDefines` and `extraAttributes` are for tests and debug views.
gl::Program makePlanePairSidesProgram(const PlanePairSidesVariant& variant,
                                      const std::vector<std::string>& extraDefines = {},
                                      const std::vector<std::string>& extraAttributes = {});
gl::Program makePlanePairCapsProgram(const PlanePairCapsVariant& variant,
                                     const std::vector<std::string>& extraDefines = {},
                                     const std::vector<std::string>& extraAttributes = {});

/// Draws shadow volumes from plane-pair records: edges with the planes of their triangles.
class PlanePairVolumes : public VolumeRenderer {
  public:
    /// Uses the silhouette, layout and ends of `settings`. `tints`: for debug views; `defines`: for
    /// all shaders, for measurements. The GL must support the layout.
    PlanePairVolumes(const RenderSettings& settings, const gl::Capabilities& capabilities,
                     std::optional<VolumeTints> tints = {}, std::vector<std::string> defines = {});

    void beginFrame(const GpuScene& scene, std::size_t mostListed) override;
    void plan(const GpuScene& scene, const CasterGroupInSlice& casters, CountPlan& plan) override;
    void prepare(const CountPlan& plan, GpuScene& scene,
                 const CasterGroupInSlice& casters) override;
    void draw(const VolumeDraw& draw, const DrawnBatch& batch) const override;
    void beginPrograms(bool directional, bool open) override;
    void forEachProgram(const gl::ProgramVisitor& visit) const override;
    /// Makes the program of such a draw, if it is missing.
    void makeProgram(const VolumeDraw& draw);

    VolumeLayout layout() const override { return VolumeLayout::planePairs; }
    const PotentialSilhouettes* silhouettes() const override {
        return silhouettes_ ? &*silhouettes_ : nullptr;
    }
    std::size_t sideBytes() const override { return gathered_.sideBytes(); }
    std::size_t capBytes() const override { return gathered_.capBytes(); }

  private:
    void makeProgram(const PlanePairSidesVariant& variant);
    void makeProgram(const PlanePairCapsVariant& variant);
    void upload(const VolumeDraw& draw, const BatchPlan& plan, PlanePairBuffers& buffers);
    const gl::Buffer& bufferOf(const VolumeDraw& draw, const DrawnBatch& batch) const;
    /// Returns the program, in use, with the uniforms that all variants need.
    const gl::Program& sidesProgram(const VolumeDraw& draw, const DrawnBatch& batch) const;

    void drawSides(const VolumeDraw& draw, const DrawnBatch& batch) const;
    void drawFans(const VolumeDraw& draw, const DrawnBatch& batch) const;
    void drawCaps(const VolumeDraw& draw, const DrawnBatch& batch) const;
    /// Draws records as quads, or as triangles of their first three corners.
    void drawRecords(const VolumeDraw& draw, const DrawnBatch& batch, bool triangles) const;
    void drawCapRecords(const CapBuffers& buffers, bool copied, const RecordRange& caps,
                        CapFaces faces, bool alphaTested) const;

    std::optional<gl::Instancing> instancing_;
    PlanSettings planning_; ///< except the silhouettes, solids and memory below
    std::optional<VolumeTints> tints_;
    std::vector<std::string> defines_;
    std::optional<PotentialSilhouettes> silhouettes_;
    KeptSolids solids_;
    PlanMemory memory_;
    std::vector<PlacedShadow> placed_; ///< of the plan that is made
    SilhouetteBuffers gathered_;
    gl::Buffer quadCorners_;     ///< instanced: 0..3
    gl::Buffer capCorners_;      ///< instanced: 0..5
    gl::Buffer quadIndices_;     ///< of one quad; not instanced: of as many as 16 bits reach
    gl::Buffer triangleIndices_; ///< the same for their first triangles
    gl::ProgramVariants<PlanePairSidesVariant> sides_;
    gl::ProgramVariants<PlanePairCapsVariant> caps_;
};

} // namespace edgeshade
