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

/// Draws frames by the three passes of docs/method.md, A frame: ambient light and depth; the shadow
/// volumes of each light into the stencil; then the lit surfaces, added. Depending on the settings,
/// shadow maps, primitive maps or shadows projected onto planes replace the volumes, or there are
/// no shadows.
///
/// First light: if its shadows need no alpha of their own and no lit mask is drawn, it is drawn
/// together with ambient light, which saves a pass over the surfaces. Alpha then holds ambient
/// light's share of the sum, which remains in shadow. Lit colours are then rounded once instead of
/// twice, coinciding surfaces are lit once, and colours in shadow are off by at most 1 of 255.
///
/// Full shading: display colours of one light and ambient light do not add up, since they are
/// tone-mapped. The light is drawn over the ambient picture, or, if both were drawn together, the
/// ambient picture over it in shadow. Only plain surfaces (Material::isPlain()) still take their
/// ambient share from alpha. Several lights are added up in a LinearTarget, or as display colours
/// if the GL has none.
///
/// Depth slices are drawn from far to near, each with its own depth range. Caps are cut at a
/// slice's near plane, and nearer geometry is in front of everything visible in the slice. Nearer
/// slices draw over farther ones.
///
/// Groups: if a point may lie in more volumes than the stencil counts, casters are counted in
/// groups (GroupedShadow), and the picture's alpha keeps the shadow of all groups. Draws into the
/// current framebuffer, which needs a stencil and alpha.
///
/// Lights without a shadow are added up in one pass, by tile, if the GL has tables of floats
/// (LightTable); otherwise each takes a pass.
///
/// Lights with a range are counted and drawn within the part of the picture that they reach, if
/// any.
///
/// Mask scale: volumes are counted in a smaller framebuffer of the renderer's own, which the lit
/// pass samples for each surface. Depth slices and groups work the same there. A fragment is either
/// lit or not: with multisampling, outlines are smooth, but shadow boundaries within a surface are
/// not.
class Renderer {
  public:
    /// Throws Error(unavailable) if the layout needs instancing and there is none, if a shadow map
    /// is larger than the GL's largest texture, if a mask scale needs derivatives in shaders and
    /// there are none, or if this build lacks a requested method.
    Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities);

    /// Draws a frame. prepareScene() must have prepared the scene; records that the plan draws are
    /// uploaded if they are missing. `clock` receives the stages; may be null. `visibility`: by
    /// light; a light without a texture, or beyond the last entry, is counted or looked up as
    /// `settings` say, from its middle alone if it has an extent. Throws Error(unavailable) if the
    /// GL can't draw masks of lower resolution.
    void draw(GpuScene& scene, const FrameView& view, StageClock* clock = nullptr,
              std::span<const VisibilityLookup> visibility = {});

    /// Makes what draw() of the same takes, ahead of it, some at each call: lists of silhouettes,
    /// and once these are there records and programs. Returns whether all is there. Draws nothing
    /// into the current framebuffer.
    bool planAhead(GpuScene& scene, const FrameView& view);

    /// Draws the nearness of visible geometry (shaders_es2/nearness.glsl) into the current
    /// framebuffer, which needs depth; 0 where there is none. In perspective, it uses the nearest
    /// slice's near plane.
    void drawNearness(const GpuScene& scene, const FrameView& view);

    /// Begins to make the programs that lit masks of these lights take, of closed
    /// casters; with `open`, of open ones, too; with `nearness`, also those of drawNearness().
    void beginMaskPrograms(std::span<const Light> lights, bool orthographic, bool nearness,
                           bool open);
    void forEachProgram(const gl::ProgramVisitor& visit) const;

    /// The plan of the last frame, valid until the next one.
    const FramePlan& plan() const { return plan_; }

    const RenderSettings& settings() const { return settings_; }
    /// The policy that chooses each light's technique in a scene.
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

    /// Memory of the shadow maps drawn so far and of shadow planes, with everything they need.
    std::size_t mapBytes() const { return techniques_.mapBytes(); }

    /// The renderer of shadow volumes; null if shadows are not volumes.
    const VolumeRenderer* volumes() const {
        return techniques_.volumes() ? &techniques_.volumes()->renderer() : nullptr;
    }

    /// Memory of the framebuffers for masks of lower resolution.
    std::size_t maskBytes() const { return coarse_ ? coarse_->bytes() : 0; }

    /// Memory of the framebuffer in which lights are added up.
    std::size_t lightBytes() const { return linear_ ? linear_->bytes() : 0; }

    /// Memory of the table of lights without a shadow.
    std::size_t tableBytes() const { return table_ ? table_->bytes() : 0; }

    /// All memory that it holds on the GPU.
    std::size_t bytes() const {
        return techniques_.bytes() + maskBytes() + lightBytes() + tableBytes();
    }

    /// Vertices shaded in the last frame for shadow volumes or shadow maps, or for the surfaces of
    /// a mask of lower resolution.
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

    /// How the lights of one frame are added up.
    struct LightSum {
        bool full = false;         ///< Shading::full
        bool replaces = false;     ///< the single light is drawn over ambient light
        bool linear = false;       ///< linear light is added up
        bool plainIsShort = false; ///< see FullShading
        double lights = 0.0;       ///< sum of the weights of the view's lights

        /// Whether shadow scales colours by the share in alpha.
        bool darkens() const { return !full || plainIsShort; }
    };

    /// drawNearness() of a scene.
    std::function<void(const FrameView&)> nearnessOf(GpuScene& scene);
    /// Begins what drawing and planning ahead share.
    void beginFrame(const FrameStart& start, std::span<const VisibilityLookup> visibility);
    LightSum lightSum(const GpuScene& scene, const FrameView& view) const;
    /// Creates what the sum needs, and binds its target.
    void prepareSum(const GpuScene& scene, const FrameView& view);
    /// Draws the frame that was planned.
    void drawSlices(GpuScene& scene, const FrameView& view, StageClock* clock);
    /// Calls use(task), with what planning a frame takes.
    void withTask(GpuScene& scene, const FrameView& view, FunctionRef<void(const FrameTask&)> use);
    /// Plans the frame into plan_, and uploads the records that it draws.
    void planFrame(const FrameTask& task, GpuScene& scene, const FrameView& view,
                   StageClock* clock);
    CasterGroupInSlice castersOf(const FrameView& view, const DepthSlice& slice, std::size_t light,
                                 std::size_t group) const;
    /// Calls use(technique, plan, casters) for every stencil of a frame.
    template <class Use>
    void forEachStencil(const FramePlan& frame, const FrameView& view, Use use);
    void prepare(const FramePlan& plan, GpuScene& scene, const FrameView& view);
    /// Draws all volumes into one pixel, whose stencil value is undefined afterwards.
    void countInOnePixel(const FramePlan& plan, const GpuScene& scene, const FrameView& view);

    void drawDepthAndAmbient(const SlicePass& pass);
    void drawCoarseSurfaces(const SlicePass& pass);
    void drawShadowedLight(const SlicePass& pass, std::size_t light);
    /// Adds the lights that have no shadow.
    void addListed(const SlicePass& pass);
    /// Uploads the table of these lights; does nothing if none are listed.
    void uploadListed(const SlicePass& pass);
    SurfaceShading listedShading(const SlicePass& pass) const;
    bool mayBeListed(const FrameView& view, std::size_t light) const;
    /// Adds the light where the stencil, or the mark of countAndMark(), has no shadow.
    void addLight(const SlicePass& pass, std::size_t light);
    /// Removes the light that was drawn with ambient light where it is in shadow.
    void drawShadow(const SlicePass& pass);
    /// Draws the surfaces again in ambient light alone, where the stencil isn't 0.
    void drawAmbientInShadow(const SlicePass& pass);
    /// Shading by one light, or by ambient light alone.
    SurfaceShading shadingOf(const SlicePass& pass, std::optional<std::size_t> light) const;
    void setFull(const SlicePass& pass, SurfaceShading& shading) const;
    void countAndMark(const SlicePass& pass, std::size_t light);
    void count(const SlicePass& pass, std::size_t light, std::size_t group);
    /// Draws what the light's surfaces sample, if its technique needs it.
    void drawLookedUp(const SlicePass& pass, std::size_t light);
    /// The light's visibility; null: unknown, its shadow is hard.
    const VisibilityLookup* visibilityOf(std::size_t light) const;
    /// Chooses each light's technique in this frame.
    void chooseTechniques(const GpuScene& scene, const FrameView& view);
    /// The technique of the light's shadow; null: it has none, or `visibility` replaces it.
    ShadowTechnique* techniqueOf(std::size_t light) const;
    /// The technique that marks the light's shadow in a stencil; null: none does.
    ShadowTechnique* markingOf(std::size_t light) const;
    /// The light's shadow map, as drawn last; null: it has none.
    const ShadowMapLookup* mapOf(std::size_t light) const;
    void drawLit(const SlicePass& pass, std::size_t light);
    void drawBlended(const SlicePass& pass);
    void drawBlendedChunk(const SlicePass& pass, const GpuBatch& batch, const SurfaceChunk& chunk,
                          SurfaceShading shading);
    void drawAsInFullLight(const SlicePass& pass, const GpuBatch& batch, const SurfaceChunk& chunk);
    /// Draws a see-through chunk in all lights, shadowed by their primitive maps if they have any.
    void drawSeeThrough(const SlicePass& pass, const GpuBatch& batch, const SurfaceChunk& chunk);
    void restoreAlpha(const GpuScene& scene, const FrameView& view);
    /// Returns vertex runs.
    std::size_t drawSurfaces(const GpuScene& scene, const FrameView& view, const DepthSlice& slice,
                             const SurfaceShading& shading);

    RenderSettings settings_;
    gl::Capabilities capabilities_;
    DeviceFacts device_;
    std::vector<LightChoice> choices_; ///< for this frame's lights
    Techniques techniques_;
    FramePlan plan_;                           ///< of the last frame
    std::vector<VisibilityLookup> visibility_; ///< for this frame's lights
    LightSum sum_;                             ///< for this frame's lights
    SurfacePass surfaces_;
    ShadowMark mark_;
    std::optional<LinearTarget> linear_;
    std::optional<LightTable> table_;           ///< set if lights may be listed
    LightTableLookup listed_;                   ///< for the slice being drawn
    std::optional<GpuEnvironment> environment_; ///< created when a surface first reflects it
    std::optional<CoarseMask> coarse_;          ///< set if volumes are counted at a lower
                                                ///< resolution
    std::size_t vertexRuns_ = 0;                ///< of the last frame
};

/// The best layout for the context: instanced if it can, otherwise not.
SidesLayout bestLayout(const gl::Capabilities& capabilities);

} // namespace edgeshade
