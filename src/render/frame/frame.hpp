#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/scissor.hpp"
#include "src/render/frame/coarse_mask.hpp"
#include "src/render/frame/linear_target.hpp"
#include "src/render/frame/shadow_mark.hpp"
#include "src/render/frame/surface_pass.hpp"
#include "src/render/frame/techniques.hpp"
#include "src/render/frame/visibility_lookup.hpp"
#include "src/render/timing/stage_clock.hpp"
#include "src/render/volumes/render_settings.hpp"
#include "src/shadow/plan/frame_plan.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <memory>
#include <optional>
#include <span>

namespace edgeshade {

/// Draws frames by the three passes of docs/method.md, A frame: ambient light and depth; for each
/// light the shadow volumes into the stencil; then the lit surfaces, added. Or with shadow maps,
/// primitive maps where lights have some, shadows projected onto planes, or none, in place of
/// volumes.
///
/// But where its shadows need no alpha of their own, and there is no lit mask to draw, the first
/// light is drawn with ambient light, which saves it a pass over the surfaces; alpha holds the
/// ambient share of both, which is what is left in shadow. Colours in light are rounded once
/// instead of twice then, surfaces that coincide are lit once, and colours in shadow are off by a
/// unit of 255 at the most.
///
/// With full shading what one light and ambient light leave on the display is no sum: the light's
/// share is drawn over the ambient one, or, where it was drawn with it, the ambient one over it
/// where there is shadow; only plain surfaces (Material::isPlain()) still take their ambient share
/// from alpha. Several lights are added up in a LinearTarget; where the GL has none the display's
/// colours are.
///
/// Depth slices are drawn from far to near, each with a depth range of its own: caps are cut at a
/// slice's near plane, and what is nearer lies in front of everything visible there; nearer slices
/// draw over the surfaces that they hold. Where more volumes may lie around a point than the
/// stencil counts, casters come in groups (GroupedShadow), and the picture's alpha remembers what
/// any group has shaded. Draws into the current framebuffer, which needs a stencil and alpha.
///
/// Lights that get no shadow are added up in one pass, tile by tile those that reach it, where the
/// GL has tables of floats (LightTable), each in a pass of its own else.
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
    /// texture is smaller than a shadow map, a mask scale needs derivatives in shaders and there
    /// are none, or this build lacks what is asked for.
    Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// The scene must have what prepareScene() makes of it; records that the plan draws are
    /// uploaded where they aren't there yet. `clock`, which may be null, is told of the stages.
    /// Throws Error(unavailable) if the GL can't draw masks of lower resolution.
    /// `visibility`: by light; one without a texture, or beyond the last, is counted or looked up
    /// as `settings` say, by its middle alone where it has an extent.
    void draw(GpuScene& scene, const FrameView& view, StageClock* clock = nullptr,
              std::span<const VisibilityLookup> visibility = {});

    /// Draws how near what is visible is (shaders_es2/nearness.glsl) into the current framebuffer,
    /// which needs depth; 0 where nothing is. Perspective: near planes are the nearest slice's.
    void drawNearness(const GpuScene& scene, const FrameView& view);

    /// What the last frame drew, until the next one.
    const FramePlan& plan() const { return plan_; }

    const RenderSettings& settings() const { return settings_; }
    /// By which it chooses each light's technique in a scene.
    ShadowPolicy policyFor(const SceneFacts& scene) const {
        return {settings_.policy(), device_, scene};
    }
    void setAmbient(float ambient) { settings_.ambient = ambient; }
    void setExposure(float stops) { settings_.exposure = stops; }
    void setBackground(const glm::vec3& color) { settings_.background = color; }
    void setMapBias(float texels) {
        settings_.map.biasTexels = texels;
        if (MapTechnique* map = techniques_.map()) map->setBias(texels);
    }

    const Techniques& techniques() const { return techniques_; }
    const gl::Capabilities& capabilities() const { return capabilities_; }

    /// Memory of the shadow maps that were drawn so far and of planes, with all that they need.
    std::size_t mapBytes() const { return techniques_.mapBytes(); }

    /// What draws shadow volumes; null where shadows are something else.
    const VolumeRenderer* volumes() const {
        return techniques_.volumes() ? &techniques_.volumes()->renderer() : nullptr;
    }

    /// Memory of the framebuffers for masks of lower resolution.
    std::size_t maskBytes() const { return coarse_ ? coarse_->bytes() : 0; }

    /// That of the one that lights are added up in.
    std::size_t lightBytes() const { return linear_ ? linear_->bytes() : 0; }

    /// That of the table of lights without a shadow.
    std::size_t tableBytes() const { return table_ ? table_->bytes() : 0; }

    /// All memory on the GPU that it holds.
    std::size_t bytes() const {
        return techniques_.bytes() + maskBytes() + lightBytes() + tableBytes();
    }

    /// Vertices that went through shadow volumes' or shadow maps' shaders in the last frame, or
    /// those of surfaces that a mask of lower resolution is made for.
    std::size_t vertexRuns() const { return vertexRuns_; }

  private:
    /// One depth slice of one frame.
    struct SlicePass {
        const GpuScene& scene;
        const FrameView& view;
        const DepthSlice& slice;
        const SlicePlan& plan;
        bool first; ///< the farthest slice, which clears the picture
        StageClock* clock = nullptr;
    };

    /// How what lights leave is put together in one frame.
    struct LightSum {
        bool full = false;         ///< Shading::full
        bool replaces = false;     ///< the one light is drawn over ambient light
        bool linear = false;       ///< light itself is added up
        bool plainIsShort = false; ///< see FullShading
        double lights = 0.0;       ///< of the view, by their weights

        /// Whether shadow leaves colours the share that alpha says.
        bool darkens() const { return !full || plainIsShort; }
    };

    LightSum lightSum(const GpuScene& scene, const FrameView& view) const;
    /// Makes what the sum takes, and binds what it is made in.
    void prepareSum(const GpuScene& scene, const FrameView& view);
    void drawSlices(GpuScene& scene, const FrameView& view, StageClock* clock);
    /// Plans the frame into plan_, and uploads what it draws.
    void planFrame(GpuScene& scene, const FrameView& view, StageClock* clock);
    void planFrame(const FrameTask& task, GpuScene& scene, const FrameView& view,
                   StageClock* clock);
    CasterGroupInSlice castersOf(const FrameView& view, const DepthSlice& slice, std::size_t light,
                                 std::size_t group) const;
    /// Calls use(technique, plan, casters) for every stencil of a frame.
    template <class Use>
    void forEachStencil(const FramePlan& frame, const FrameView& view, Use use);
    void prepare(const FramePlan& plan, GpuScene& scene, const FrameView& view);
    /// Draws all volumes into one pixel, which leaves its stencil in disorder.
    void countInOnePixel(const FramePlan& plan, const GpuScene& scene, const FrameView& view);

    void drawDepthAndAmbient(const SlicePass& pass);
    void drawCoarseSurfaces(const SlicePass& pass);
    void drawShadowedLight(const SlicePass& pass, std::size_t light);
    /// Adds the lights that have no shadow.
    void addListed(const SlicePass& pass);
    /// What surfaces look up of these; nothing where none are listed.
    void uploadListed(const SlicePass& pass);
    SurfaceShading listedShading(const SlicePass& pass) const;
    bool mayBeListed(const FrameView& view, std::size_t light) const;
    /// Adds it where the stencil, or what countAndMark() left, has no shadow.
    void addLight(const SlicePass& pass, std::size_t light);
    /// Takes the light that was drawn with ambient light from where it is in shadow.
    void drawShadow(const SlicePass& pass);
    /// What ambient light leaves, where the stencil isn't 0: the surfaces drawn once more.
    void drawAmbientInShadow(const SlicePass& pass);
    /// By the light, or by nothing.
    SurfaceShading shadingOf(const SlicePass& pass, std::optional<std::size_t> light) const;
    void setFull(const SlicePass& pass, SurfaceShading& shading) const;
    void countAndMark(const SlicePass& pass, std::size_t light);
    void count(const SlicePass& pass, std::size_t light, std::size_t group);
    /// Draws what the light's surfaces look up, if its technique has them look something up.
    void drawLookedUp(const SlicePass& pass, std::size_t light);
    /// How much of the light is seen; null: not known, its shadow is hard.
    const VisibilityLookup* visibilityOf(std::size_t light) const;
    /// Chooses each light's technique in this frame.
    void chooseTechniques(const GpuScene& scene, const FrameView& view);
    /// Makes the light's shadow; null: it has none, or `visibility` says what is seen of it.
    ShadowTechnique* techniqueOf(std::size_t light) const;
    /// Marks what of the light's shadow a stencil says; null: none does.
    ShadowTechnique* markingOf(std::size_t light) const;
    /// The light's shadow map, as it was drawn last; null: it has none.
    const ShadowMapLookup* mapOf(std::size_t light) const;
    void drawLit(const SlicePass& pass, std::size_t light);
    void drawBlended(const SlicePass& pass);
    void drawBlendedChunk(const SlicePass& pass, const GpuBatch& batch, const SurfaceChunk& chunk,
                          SurfaceShading shading);
    void drawAsInFullLight(const SlicePass& pass, const GpuBatch& batch, const SurfaceChunk& chunk);
    /// In all lights, as far as their primitive maps say, where they have some.
    void drawSeeThrough(const SlicePass& pass, const GpuBatch& batch, const SurfaceChunk& chunk);
    void restoreAlpha(const GpuScene& scene, const FrameView& view);
    /// Returns vertex runs.
    std::size_t drawSurfaces(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
                             const SurfaceShading& shading);

    RenderSettings settings_;
    gl::Capabilities capabilities_;
    DeviceFacts device_;
    std::vector<LightChoice> choices_; ///< of the lights of this frame
    Techniques techniques_;
    FramePlan plan_;                           ///< of the last frame
    std::vector<VisibilityLookup> visibility_; ///< of the lights of this frame
    LightSum sum_;                             ///< likewise
    SurfacePass surfaces_;
    ShadowMark mark_;
    std::optional<LinearTarget> linear_;
    std::optional<LightTable> table_;           ///< where lights may be listed
    LightTableLookup listed_;                   ///< of the slice that is drawn
    std::optional<GpuEnvironment> environment_; ///< once a surface has reflected it
    std::optional<CoarseMask> coarse_;          ///< where volumes are counted at a lower resolution
    std::size_t vertexRuns_ = 0;                ///< of the last frame
};

/// The layout that suits the context: instanced where it can, else not.
SidesLayout bestLayout(const gl::Capabilities& capabilities);

} // namespace edgeshade
