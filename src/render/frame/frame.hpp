#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/scissor.hpp"
#include "src/render/frame/coarse_mask.hpp"
#include "src/render/frame/shadow_mark.hpp"
#include "src/render/frame/surface_pass.hpp"
#include "src/render/shadow_map/shadow_map_pass.hpp"
#include "src/render/timing/stage_clock.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/render/volumes/volume_counter.hpp"
#include "src/shadow/geometry/frame_view.hpp"
#include "src/shadow/geometry/light_reach.hpp"

#include <optional>

namespace edgeshade {

/// Draws frames by the three passes of docs/method.md, A frame: ambient light and depth; for each
/// light the shadow volumes into the stencil; then the lit surfaces, added. Or with shadow maps, or
/// with none, in place of volumes.
///
/// But where its shadows need no alpha of their own, and there is no lit mask to draw, the first
/// light is drawn with ambient light, which saves it a pass over the surfaces; alpha holds the
/// ambient share of both, which is what is left in shadow. Colours in light are rounded once
/// instead of twice then, surfaces that coincide are lit once, and colours in shadow are off by a
/// unit of 255 at the most.
///
/// Depth slices are drawn from far to near, each with a depth range of its own: caps are cut at a
/// slice's near plane, and what is nearer lies in front of everything visible there; nearer slices
/// draw over the surfaces that they hold. Where more volumes may lie around a point than the
/// stencil counts, casters come in groups (GroupedShadow), and the picture's alpha remembers what
/// any group has shaded. Draws into the current framebuffer, which needs a stencil and alpha.
///
/// Lights with a range are counted and drawn within the part of the picture that they reach, if
/// any.
///
/// With a mask scale volumes are counted in a smaller framebuffer of the renderer's own, from which
/// the lit pass looks up what its surface has. Depth slices and groups of casters are the same
/// there. A fragment is lit or not as a whole: with samples outlines are smooth, and boundaries of
/// shadows within a surface are not.
class Renderer {
  public:
    /// Throws Error(unavailable) if the layout needs instancing and there is none, the GL's largest
    /// texture is smaller than a shadow map, or a mask scale needs derivatives in shaders and there
    /// are none.
    Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// The scene must have the groups of casters that the lights' layers ask for, see
    /// OverflowGroups. `clock`, which may be null, is told of the stages. Throws
    /// Error(unavailable) if the GL can't draw masks of lower resolution.
    void draw(const GpuScene& scene, const FrameView& view, StageClock* clock = nullptr);

    const RenderSettings& settings() const { return settings_; }
    void setAmbient(float ambient) { settings_.ambient = ambient; }
    void setBackground(const glm::vec3& color) { settings_.background = color; }
    void setMapBias(float texels) {
        settings_.map.biasTexels = texels;
        if (maps_) maps_->setBias(texels);
    }

    /// Memory of the shadow maps that were drawn so far.
    std::size_t mapBytes() const { return maps_ ? maps_->bytes() : 0; }

    /// The records that are proposed for the lights of late; null where none are.
    const Proposals* proposals() const { return counter_.proposals(); }

    /// Memory of the framebuffers for masks of lower resolution.
    std::size_t maskBytes() const { return coarse_ ? coarse_->bytes() : 0; }

    /// All memory on the GPU that it holds.
    std::size_t bytes() const {
        return mapBytes() + maskBytes() + (proposals() ? proposals()->bytes() : 0);
    }

    /// Vertices that went through shadow volumes' or shadow maps' shaders in the last frame, or
    /// those of surfaces that a mask of lower resolution is made for.
    std::size_t vertexRuns() const { return vertexRuns_; }

  private:
    /// One depth slice of one frame.
    struct Pass {
        const GpuScene& scene;
        const FrameView& view;
        const DepthSlice& slice;
        bool first; ///< the farthest slice, which clears the picture
        StageClock* clock = nullptr;
        glm::ivec2 counted{0}; ///< size of the framebuffer that volumes are counted in
    };

    /// Whether nothing is counted where no surface is; the published method counts everywhere.
    bool cutsToVisible() const;
    /// Its casters in groups, or null.
    const GroupedShadow* groupsOf(const Pass& pass, std::size_t light) const;
    /// The first light that reaches something and whose shadows need no alpha of their own.
    std::optional<std::size_t> firstByItself(const Pass& pass,
                                             const std::vector<PixelRectangle>& reaches) const;
    /// `light`: drawn with ambient light, may be null. `stencil`: what it is cleared to.
    void drawDepthAndAmbient(const Pass& pass, const Light* light, int stencil);
    void drawCoarseSurfaces(const Pass& pass, const PixelRectangle& reach);
    /// `prepared`: for it the stencil is cleared; null where it isn't.
    void drawShadowedLight(const Pass& pass, std::size_t light, const GroupedShadow* groups,
                           const PixelRectangle& reach, const PreparedCount* prepared);
    /// Takes the light that was drawn with ambient light from where it is in shadow.
    void drawShadow(const Pass& pass, const PixelRectangle& reach, const PreparedCount& prepared);
    /// By the light, or by nothing.
    SurfaceShading shadingOf(const Pass& pass, const Light* light) const;
    /// Returns whether anything may be lit.
    bool countAndMark(const Pass& pass, std::size_t light, const GroupedShadow* groups,
                      const PixelRectangle& reach);
    void setCounting();
    PreparedCount prepareCount(const Pass& pass, std::size_t light,
                               const VolumesOfBatch& volumesOf);
    void count(const Pass& pass, const PreparedCount& prepared);
    ShadowMapLookup drawMap(const Pass& pass, const Light& light);
    void drawLit(const Pass& pass, const Light& light, const ShadowMapLookup* map);
    void drawBlended(const Pass& pass);
    void restoreAlpha(const GpuScene& scene, const FrameView& view);
    /// Returns vertex runs.
    std::size_t drawSurfaces(const Pass& pass, const SurfaceShading& shading);

    RenderSettings settings_;
    VolumeCounter counter_;
    SurfacePass surfaces_;
    ShadowMark mark_;
    std::optional<ShadowMapPass> maps_; ///< where shadows are maps
    std::optional<CoarseMask> coarse_;  ///< where volumes are counted at a lower resolution
    std::size_t vertexRuns_ = 0;        ///< of the last frame
};

/// The layout that suits the context: instanced where it can, else not.
SidesLayout bestLayout(const gl::Capabilities& capabilities);

} // namespace edgeshade
