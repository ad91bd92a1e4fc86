#pragma once

#include "src/gl/program_variants.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/render/volumes/volume_renderer.hpp"
#include "src/rivals/published/shadow_buffers.hpp"

#include <optional>

namespace edgeshade {

/// Draws the shadow volume of every casting triangle by itself (Sambeek 2007). It uses no edges, so
/// any triangle soup is counted correctly, and nothing cancels before it is drawn.
///
/// Behind surfaces (z-fail), each triangle has two caps and three sides. Before surfaces (z-pass),
/// only sides are drawn, and each triangle is projected from the light onto the near plane, where
/// it marks the pixels that begin within its volume (ZP+: Hornus et al. 2005). If the light almost
/// lies in the near plane, that projection vanishes, and volumes are counted behind surfaces.
class TriangleVolumes : public VolumeRenderer {
  public:
    /// `instancing` is required unless the layout is notInstanced; all other layouts count as
    /// instanced. `tints`: for debug views.
    TriangleVolumes(BruteForceCount count, SidesLayout layout,
                    std::optional<gl::Instancing> instancing,
                    std::optional<VolumeTints> tints = {});

    void plan(const GpuScene& scene, const CasterGroupInSlice& casters, CountPlan& plan) override;
    void prepare(const CountPlan& plan, GpuScene& scene,
                 const CasterGroupInSlice& casters) override;
    void draw(const VolumeDraw& draw, const DrawnBatch& batch) const override;
    VolumeLayout layout() const override { return VolumeLayout::triangles; }

  private:
    struct Variant {
        bool nearCaps, nearDiscard, alphaTest, contact;

        auto operator<=>(const Variant&) const = default;
    };
    /// A range of a record's vertices, in the order of brute_force/triangle_volume.vert.
    struct Vertices {
        int first, count;
    };

    static Variant variantOf(const VolumeDraw& draw, const BatchPlan& plan);
    static Vertices verticesOf(const VolumeDraw& draw, const DrawnBatch& batch);
    gl::Program makeProgram(const Variant& variant) const;
    void drawRecords(const gl::Program& program, const ShadowBuffers& triangles,
                     const RecordRange& range, const Vertices& vertices, bool alphaTested) const;

    BruteForceCount count_;
    bool copied_; ///< each record is copied for every vertex
    std::optional<gl::Instancing> instancing_;
    std::optional<VolumeTints> tints_;
    gl::Buffer corners_; ///< vertex numbers v within a record
    gl::ProgramVariants<Variant> programs_;
};

} // namespace edgeshade
