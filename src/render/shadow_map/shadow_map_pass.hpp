#pragma once

#include "src/gl/program.hpp"
#include "src/render/shadow_map/map_blur.hpp"
#include "src/render/shadow_map/shadow_map_target.hpp"
#include "src/render/shadow_map/shadow_map_view.hpp"
#include "src/render/shadow_map/warp_table.hpp"
#include "src/render/shadow_map/warped_casters.hpp"
#include "src/scene/gpu_scene.hpp"

#include <map>

namespace edgeshade {

/// Draws shadow maps (Williams 1978), the method that shadow volumes are measured against: six
/// faces of a cube or two paraboloids around a point light, one parallel projection or several for
/// a directional light; and filters them, if so set. One map of each kind is kept, and drawn anew
/// only for another light, where something has moved, or cascades by a texel.
class ShadowMapPass {
  public:
    /// Throws Error(unavailable) if the maps are larger than the GL allows.
    ShadowMapPass(const ShadowMapSettings& settings, const gl::Capabilities& capabilities);

    /// Draws the light's map of all casters in its range, from both sides, for what `frame` shows.
    /// The framebuffer stays bound and the scissor as it is; viewport, depth, stencil and blending
    /// state are left changed. The map is valid until the next call.
    /// `visible`: places of what is seen, in the world, for which maps are warped.
    ShadowMapLookup draw(const GpuScene& scene, const FrameView& frame, const Light& light,
                         std::span<const glm::dvec3> visible = {});

    /// Of lookups from now on.
    void setBias(float texels) { settings_.biasTexels = texels; }

    /// Of the maps that were needed so far, with what filters and warps them.
    std::size_t bytes() const;
    /// Of the one that the light's kind has, without what filters it; 0 before one was drawn.
    std::size_t bytesOf(const Light& light) const;

    /// Vertices that the last call of draw() sent through shaders: 0 where the map was kept.
    std::size_t vertexRuns() const { return vertexRuns_; }

  private:
    struct Variant {
        ShadowMapKind kind;
        bool alphaTest;

        auto operator<=>(const Variant&) const = default;
    };
    /// What a map shows.
    struct Drawn {
        std::shared_ptr<const int> scene; ///< GpuScene::identity; held, so that it stays unique
        ShadowMapView view;
        std::vector<std::pair<glm::dmat4, bool>> batches; ///< worldFromBatch, hidden
        bool cutoutsCast;
        double range; ///< of the light, out of which nothing is drawn

        bool operator==(const Drawn&) const = default;
    };
    static MapSubject subjectOf(const GpuScene& scene, const Box& bounds);
    static Drawn drawnOf(const GpuScene& scene, const ShadowMapView& view, const Light& light);
    const ShadowMapTarget& target(ShadowMapKind kind);
    void drawFaces(const GpuScene& scene, const ShadowMapView& view, const ShadowMapTarget& map,
                   const Light& light);
    gl::Program& program(const Variant& variant);
    void drawCasters(const GpuScene& scene, const ShadowMapView& view, std::size_t face,
                     const Light& light);
    void drawWarped(const GpuScene& scene, const ShadowMapView& view);
    void setHalf(const gl::Program& program, const ShadowMapView& view, std::size_t face) const;
    std::size_t warpBytes() const;

    ShadowMapSettings settings_;
    gl::Capabilities capabilities_;
    std::map<ShadowMapKind, ShadowMapTarget> targets_;
    std::map<ShadowMapKind, Drawn> drawn_; ///< what each target holds
    std::map<Variant, gl::Program> programs_;
    std::optional<MapBlur> blur_;   ///< once a map was filtered
    std::optional<WarpTable> warp_; ///< once one was warped
    WarpedCasters warpedCasters_;   ///< likewise, of the last one
    std::size_t vertexRuns_ = 0;
};

} // namespace edgeshade
