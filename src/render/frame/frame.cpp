#include "src/render/frame/frame.hpp"

#include "preprocess/base/error.hpp"
#include "src/environment/neutral.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/frame/grazed_surfaces.hpp"
#include "src/render/frame/volume_renderers.hpp"
#include "src/render/irregular/irregular_shadow_pass.hpp"
#include "src/render/volumes/stencil_count.hpp"
#include "src/scene/build_parts.hpp"
#include "src/scene/shadow_facts.hpp"
#include "src/shadow/geometry/light_reach.hpp"
#include "src/shadow/plan/light_lists.hpp"

#include <algorithm>
#include <cmath>
#include <GLES2/gl2.h>
#include <numbers>

namespace edgeshade {
namespace {

/// Whether volumes are drawn from records of what the scene requires.
bool areAdapted(const RenderSettings& settings) {
    const auto records = settings.records();
    return !records || records->volumes == VolumeLayout::planePairs;
}

/// Opposite-vertex records and triangles are counted where a far plane at a finite depth cuts
/// volumes and every caster must be in the depth buffer (docs/method.md, C33 and C39).
void requireCountable(const RenderSettings& settings, const FrameView& view) {
    if (areAdapted(settings)) return;
    const std::string what = settings.records()->volumes == VolumeLayout::triangles
                                 ? "Brute-force volumes"
                                 : "Opposite-vertex records";
    if (view.frustum.orthographic)
        throw Error(ExitStatus::unavailable, what + " can't be counted in an orthographic picture; "
                                                    "'--multiplicity plane' can.");
    if (view.culls)
        throw Error(ExitStatus::unavailable,
                    what + " don't say which side of a triangle is its front, so "
                           "that culled casters can't be counted; '--multiplicity plane' can.");
}

/// Lights of a picture without any shadows from which they are listed; fewer take a pass each, as
/// they always did.
constexpr std::size_t manyUnshadowed = 9;

/// Where lines of sight come from, from the camera's position.
glm::vec4 eyeFrom(const Frustum& frustum) {
    const glm::dvec4 eye = frustum.eye();
    return glm::vec4(glm::dvec3(eye) - frustum.position() * eye.w, eye.w);
}

/// What of white light the display shows so.
float lightShown(float displayed) {
    return std::pow(displayed, 2.2f);
}

/// Of the neutral environment: how much more a white surface sends back that looks up than one that
/// looks aside (neutralRadiance(), to the first order).
constexpr float neutralSlope = 0.59f;

/// Whether plain surfaces need no curve but a power: all light is white, and nothing is brighter
/// than the display shows.
bool isPlain(const RenderSettings& settings) {
    return settings.exposure <= 0.0f && !settings.environment;
}

bool isPlain(const Light& light) {
    const glm::vec3& color = light.color;
    return !light.photometric && color.r == color.g && color.g == color.b && color.r <= 1.0f;
}

bool isFullyShadowed(const LightPlan& light) {
    return std::any_of(light.counts.begin(), light.counts.end(),
                       [](const CountPlan& count) { return count.fullyShadowed; });
}

CountPlan askingPoints() {
    CountPlan plan;
    plan.byPoints = true;
    return plan;
}

/// Calls use(plan, casters) for everything that a frame counts by drawing.
template <class Use>
void forEachCount(const FramePlan& frame, const FrameView& view, Use use) {
    for (std::size_t s = 0; s < frame.slices.size(); ++s)
        for (std::size_t light = 0; light < frame.slices[s].lights.size(); ++light) {
            const auto& counts = frame.slices[s].lights[light].counts;
            for (std::size_t group = 0; group < counts.size(); ++group)
                if (!counts[group].byPoints)
                    use(counts[group], CasterGroupInSlice{view, view.slices[s], light, group});
        }
}

} // namespace

SidesLayout bestLayout(const gl::Capabilities& capabilities) {
    return capabilities.instancing ? SidesLayout::instanced : SidesLayout::notInstanced;
}

Renderer::Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : settings_(settings), device_(deviceFactsOf(capabilities)),
      volumes_(makeVolumeRenderer(settings, capabilities)), counter_(capabilities),
      surfaces_(capabilities, settings.map.pcf) {
    if (settings.shadows == ShadowMethod::map) maps_.emplace(settings.map, capabilities);
    if (settings.shadows == ShadowMethod::planar) {
        if constexpr (hasRivals)
            planar_.emplace();
        else
            throw Error(ExitStatus::unavailable, "This build has no planar shadows.");
    }
    const bool mayAskPoints = policyFor({}).mayAskPoints();
    if (settings.shadows == ShadowMethod::irregularZBuffer && !mayAskPoints)
        throw Error(ExitStatus::unavailable,
                    "'--shadows irregular-z-buffer' needs a GL whose processor draws, with one "
                    "sample a pixel and framebuffers with depth (GL_OES_packed_depth_stencil); "
                    "'--shadows volumes' does without.");
    if constexpr (hasPoints)
        if (mayAskPoints) irregular_ = std::make_shared<IrregularShadowPass>(capabilities);
    if (maps_ && settings.map.kind == MapKind::warped) places_.emplace(capabilities);
    if (settings.shading == Shading::full && LinearTarget::isPossible(capabilities))
        linear_.emplace(capabilities);
    if constexpr (listsLights)
        if (LightTable::isPossible(capabilities)) table_.emplace(capabilities);
    if constexpr (marksGrazed) grazed_ = std::make_shared<GrazedSurfaces>();
    if (settings.records() && settings.maskScale > 1)
        coarse_.emplace(settings.maskScale, capabilities);
}

void Renderer::draw(GpuScene& scene, const FrameView& view, StageClock* clock,
                    std::span<const VisibilityLookup> visibility) {
    vertexRuns_ = 0;
    visibility_.assign(visibility.begin(), visibility.end());
    requireCountable(settings_, view);
    if (coarse_) {
        const gl::FramebufferKeeper keeper;
        coarse_->fit(view.width, view.height);
    }
    GLint framebuffer = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
    findVisible(scene, view, clock);
    sum_ = lightSum(scene, view);
    prepareSum(scene, view);
    drawSlices(scene, view, clock);
    if (sum_.linear) linear_->show(static_cast<gl::Name>(framebuffer));
}

Renderer::LightSum Renderer::lightSum(const GpuScene& scene, const FrameView& view) const {
    LightSum sum;
    for (const FrameLight& of : view.lights)
        sum.lights += of.weight;
    if (settings_.shading == Shading::base || view.mask || settings_.tintPrimitives) return sum;
    sum.full = true;
    sum.replaces = view.lights.size() == 1;
    // All or none: Neutral shows dark and deep colours darker than the short way.
    sum.plainIsShort =
        sum.replaces && scene.plain && isPlain(settings_) && isPlain(view.lights.front().light);
    return sum;
}

void Renderer::prepareSum(const GpuScene& scene, const FrameView& view) {
    if (!sum_.full) return;
    const bool reflects = !sum_.plainIsShort || scene.seeThrough;
    if (reflects && !environment_)
        environment_.emplace(settings_.environment ? *settings_.environment : neutralEnvironment());
    sum_.linear = !sum_.replaces && linear_ && linear_->bind(view.width, view.height);
}

std::size_t Renderer::markBytes() const {
    if constexpr (hasPoints) return irregular_ ? irregular_->bytes() : 0;
    return 0;
}

void Renderer::drawSlices(GpuScene& scene, const FrameView& view, StageClock* clock) {
    chooseTechniques(scene, view);
    plan_ = planned(scene, view, clock);
    glViewport(0, 0, view.width, view.height);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    bool marked = false;
    for (std::size_t s = 0; s < view.slices.size(); ++s) {
        const SlicePass pass{scene, view, view.slices[s], plan_.slices[s], s == 0, clock};
        if (marked) mark_.clear(); // the light with ambient light has its share in alpha
        drawDepthAndAmbient(pass);
        if constexpr (hasPoints)
            if (irregular_) irregular_->forgetSurfaces();
        if (coarse_ && !pass.plan.reach.empty()) drawCoarseSurfaces(pass);
        if (pass.plan.withAmbient && pass.plan.lights[*pass.plan.first].isCounted())
            drawShadow(pass);
        for (std::size_t i = 0; i < pass.plan.lights.size(); ++i) {
            const LightPlan& light = pass.plan.lights[i];
            if (light.reach.empty() || light.listed ||
                (pass.plan.withAmbient && i == *pass.plan.first))
                continue;
            drawShadowedLight(pass, i);
            marked = marked || (light.inGroups() && !coarse_);
        }
        if (pass.plan.lists) {
            uploadListed(pass);
            addListed(pass);
        }
        if (!view.mask && view.drawBlended) drawBlended(pass);
    }
    if (marked) restoreAlpha(scene, view);
}

FramePlan Renderer::planned(GpuScene& scene, const FrameView& view, StageClock* clock) {
    FrameTask task{.view = view,
                   .open = gl::scissored(view.width, view.height),
                   .ownStencil = coarse_.has_value(),
                   .ambientApart = sum_.full && !sum_.replaces,
                   .groupCount = [](std::size_t) { return std::size_t{0}; },
                   .planCount = {}};
    if (cutsToVisible()) task.open = intersection(task.open, visiblePixels(view));
    task.groupCount = [&](std::size_t light) -> std::size_t {
        switch (countedFor(light)) {
        case Technique::points:
        case Technique::planar:
            return 1;
        case Technique::volumes:
            return scene.groupCount(view.lights[light], volumes_->layout());
        default:
            return 0;
        }
    };
    task.planCount = [&](const DepthSlice& slice, std::size_t light, std::size_t group) {
        switch (countedFor(light)) {
        case Technique::points:
            return askingPoints();
        case Technique::volumes:
            return volumes_->plan(
                scene, {view, slice, light, group, choices_[light].technique == Technique::lookup});
        default:
            return CountPlan();
        }
    };
    if constexpr (listsLights)
        if (table_) {
            task.mayBeListed = [&](std::size_t light) { return mayBeListed(view, light); };
            task.list = listLights;
        }
    if (!volumes_) return planFrame(task);
    volumes_->beginFrame(scene);
    if (clock && clock->wantsSilhouette()) {
        const StageScope stage(clock, FrameStage::silhouette);
        const FramePlan plan = planFrame(task);
        prepare(plan, scene, view);
        countInOnePixel(plan, scene, view);
    }
    const StageScope stage(clock, FrameStage::volumes);
    FramePlan plan = planFrame(task);
    prepare(plan, scene, view);
    return plan;
}

void Renderer::prepare(const FramePlan& plan, GpuScene& scene, const FrameView& view) {
    forEachCount(plan, view, [&](const CountPlan& count, const CasterGroupInSlice& casters) {
        volumes_->prepare(count, scene, casters);
    });
}

void Renderer::countInOnePixel(const FramePlan& plan, const GpuScene& scene,
                               const FrameView& view) {
    const gl::ScissorScope onePixel({0, 0, 1, 1});
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
    setCounting();
    glViewport(0, 0, 1, 1);
    forEachCount(plan, view, [&](const CountPlan& count, const CasterGroupInSlice& casters) {
        counter_.count(count, *volumes_, scene, casters);
    });
}

void Renderer::findVisible(const GpuScene& scene, const FrameView& view, StageClock* clock) {
    if constexpr (allMapKinds) {
        const auto isWarped = [&](const FrameLight& of) {
            return of.drawn && mapKindOf(of.light, settings_.map) == ShadowMapKind::warped;
        };
        if (!places_ || std::none_of(view.lights.begin(), view.lights.end(), isWarped)) return;
        const StageScope stage(clock, FrameStage::map);
        visible_ = places_->find(view, [&](const FrameView& of) { drawNearness(scene, of); });
    }
}

std::size_t Renderer::drawSurfaces(const GpuScene& scene, const FrameView& view,
                                   const DepthSlice& slice, const SurfaceShading& shading) {
    std::size_t runs = 0;
    const glm::dvec3 eye = view.frustum.position();
    const ViewPlanes planes = viewPlanes(view, slice, glm::dmat4(1.0));
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden || (batch.ground && !view.ground) || isOutOfView(batch, planes)) continue;
        const BatchView batchView = surfaceViewOf(scene, batch, view, slice, shading);
        for (const AlphaMode kind : {AlphaMode::opaque, AlphaMode::mask})
            runs += surfaces_.draw(scene, batch, batchView, eye, shading, kind);
    }
    return runs;
}

void Renderer::drawNearness(const GpuScene& scene, const FrameView& view) {
    PlaneSpace space{.near = static_cast<float>(view.near())};
    if (view.frustum.orthographic)
        space.depthRange = static_cast<float>(view.farPlane - view.near());
    glViewport(0, 0, view.width, view.height);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glEnable(GL_DEPTH_TEST);
    for (const GLenum off : {GL_BLEND, GL_CULL_FACE, GL_DITHER, GL_STENCIL_TEST})
        glDisable(off);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const DepthSlice& slice : view.slices) {
        glClear(GL_DEPTH_BUFFER_BIT);
        SurfaceShading shading;
        shading.nearness = &space;
        shading.farthest = static_cast<float>(slice.far * sliceOverlap);
        drawSurfaces(scene, view, slice, shading);
    }
    glEnable(GL_DITHER);
}

bool Renderer::cutsToVisible() const {
    return areAdapted(settings_);
}

void Renderer::drawDepthAndAmbient(const SlicePass& pass) {
    const std::optional<std::size_t> light = pass.plan.withAmbient ? pass.plan.first : std::nullopt;
    std::optional<ShadowMapLookup> map;
    if (light) map = mapOf(pass, *light);
    const StageScope stage(pass.clock, FrameStage::ambient);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    if (pass.first) {
        const glm::vec4 clear =
            pass.view.mask ? glm::vec4(0.0f)
            : sum_.linear  ? glm::vec4(LinearTarget::lightShownAs(settings_.background), 1.0f)
                           : glm::vec4(settings_.background, 1.0f);
        glClearColor(clear.r, clear.g, clear.b, clear.a);
    }
    // Depth and stencil at once: one without the other is dear where they share their bytes.
    setStencilClear(pass.plan.start());
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | (pass.first ? GL_COLOR_BUFFER_BIT : 0));

    SurfaceShading shading = shadingOf(pass, light);
    if (light) {
        shading.withAmbient = true;
        shading.map = map ? &*map : nullptr;
        // Alpha, which is 1, is the volumes'.
        const bool counted = pass.plan.lights[*light].isCounted();
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, counted && sum_.darkens());
    }
    drawSurfaces(pass.scene, pass.view, pass.slice, shading);
}

void Renderer::drawShadow(const SlicePass& pass) {
    const gl::ScissorScope cut(pass.plan.lights[*pass.plan.first].reach);
    count(pass, *pass.plan.first, 0);
    const StageScope stage(pass.clock, FrameStage::lit);
    if (sum_.darkens()) {
        mark_.darkenCounted();
        mark_.clear();
    } else {
        drawAmbientInShadow(pass);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

void Renderer::drawAmbientInShadow(const SlicePass& pass) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    glDisable(GL_BLEND);
    // Of surfaces that coincide the first is drawn, as it was with the light.
    glStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
    drawSurfaces(pass.scene, pass.view, pass.slice, shadingOf(pass, {}));
}

/// Depth and planes of what is visible, for the masks of all lights.
void Renderer::drawCoarseSurfaces(const SlicePass& pass) {
    const StageScope stage(pass.clock, FrameStage::volumes);
    const gl::FramebufferKeeper keeper;
    coarse_->bindSurfaces();
    const gl::ScissorScope cut(scaledReach(pass.plan.reach, pass.view, coarse_->size()));
    glDisable(GL_DITHER); // the bytes are no colour
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const PlaneSpace planes = coarse_->space(pass.view, pass.slice);
    SurfaceShading shading = shadingOf(pass, {});
    shading.planes = &planes;
    vertexRuns_ += drawSurfaces(pass.scene, pass.view, pass.slice, shading);
    glEnable(GL_DITHER);
    glViewport(0, 0, pass.view.width, pass.view.height);
}

void Renderer::drawShadowedLight(const SlicePass& pass, std::size_t light) {
    const LightPlan& plan = pass.plan.lights[light];
    const gl::ScissorScope cut(plan.reach);
    const std::optional<ShadowMapLookup> map = mapOf(pass, light);
    if (plan.isCounted()) {
        if (light == pass.plan.first)
            count(pass, light, 0);
        else
            countAndMark(pass, light);
    }
    if (!isFullyShadowed(plan)) addLight(pass, light, map ? &*map : nullptr);
    glDisable(GL_STENCIL_TEST);
}

void Renderer::addLight(const SlicePass& pass, std::size_t light, const ShadowMapLookup* map) {
    const LightPlan& plan = pass.plan.lights[light];
    const StageScope stage(pass.clock, FrameStage::lit);
    const bool counted = plan.isCounted() && !coarse_ && !plan.inGroups();
    if (!counted) clearStencil();
    setAddingLight(plan.inGroups() && !coarse_);
    drawLit(pass, light, map);
}

bool Renderer::mayBeListed(const FrameView& view, std::size_t light) const {
    if (visibilityOf(light) || settings_.tintPrimitives) return false;
    return !view.lights[light].shadowed ||
           (settings_.shadows == ShadowMethod::none && view.lights.size() >= manyUnshadowed);
}

void Renderer::uploadListed(const SlicePass& pass) {
    if constexpr (listsLights) {
        const StageScope stage(pass.clock, FrameStage::lit);
        listed_ = table_->upload(*pass.plan.lists, pass.view, [&](std::size_t light) {
            const SurfaceShading shading = shadingOf(pass, light);
            return shading.full ? shading.full->lightColor : glm::vec3(shading.diffuse);
        });
    }
}

SurfaceShading Renderer::listedShading(const SlicePass& pass) const {
    SurfaceShading shading = shadingOf(pass, {});
    shading.listed = &listed_;
    shading.diffuse = std::max(1.0f - shading.ambient, 0.0f) / static_cast<float>(sum_.lights);
    return shading;
}

void Renderer::addListed(const SlicePass& pass) {
    const StageScope stage(pass.clock, FrameStage::lit);
    const gl::ScissorScope cut(pass.plan.lists->reach);
    clearStencil();
    setAddingLight(false);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    drawSurfaces(pass.scene, pass.view, pass.slice, listedShading(pass));
    glDisable(GL_STENCIL_TEST);
}

void Renderer::setAddingLight(bool marked) const {
    setLightBlending(marked);
    // Of surfaces that coincide the first is lit, as it is by ambient light.
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
}

/// `marked`: what a group has shaded has alpha 0 and takes no light.
void Renderer::setLightBlending(bool marked) const {
    glEnable(GL_BLEND);
    const GLenum light = marked ? GL_DST_ALPHA : GL_ONE;
    const GLenum dark = marked ? GL_ONE_MINUS_DST_ALPHA : GL_ZERO;
    glBlendFuncSeparate(light, sum_.replaces ? dark : GL_ONE, GL_ZERO, GL_ONE);
}

/// Leaves what is in shadow in the stencil; where there are groups or a lower resolution, in alpha.
void Renderer::countAndMark(const SlicePass& pass, std::size_t light) {
    const LightPlan& plan = pass.plan.lights[light];
    std::optional<gl::FramebufferKeeper> keeper;
    std::optional<gl::ScissorScope> cut;
    if (coarse_) {
        keeper.emplace();
        coarse_->bindCounts();
        cut.emplace(scaledReach(plan.reach, pass.view, coarse_->size()));
    }
    const bool marks = plan.inGroups() || coarse_;
    if (marks) mark_.clear();
    for (std::size_t group = 0; group < plan.counts.size(); ++group) {
        clearStencil(plan.counts[group].start);
        count(pass, light, group);
        if (marks) mark_.markCounted();
    }
    if (coarse_) glViewport(0, 0, pass.view.width, pass.view.height);
}

void Renderer::setCounting() {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(0xFF);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
}

void Renderer::count(const SlicePass& pass, std::size_t light, std::size_t group) {
    const StageScope stage(pass.clock, FrameStage::volumes);
    const CountPlan& plan = pass.plan.lights[light].counts[group];
    setCounting();
    if constexpr (hasRivals)
        if (planar_) {
            vertexRuns_ +=
                planar_->mark(pass.scene, pass.view, pass.slice, pass.view.lights[light].light);
            return;
        }
    if constexpr (hasPoints)
        if (plan.byPoints) {
            irregular_->mark(pass.scene, pass.view, pass.slice, pass.view.lights[light].light,
                             pass.plan.lights[light].reach, pass.plan.reach,
                             choices_[light].technique == Technique::lookup);
            return;
        }
    counter_.count(plan, *volumes_, pass.scene, {pass.view, pass.slice, light, group});
    vertexRuns_ += plan.vertexRuns();
    if constexpr (marksGrazed)
        if (!coarse_ && group == 0) grazed_->mark(pass.scene, pass.view, pass.slice, light);
}

std::optional<ShadowMapLookup> Renderer::mapOf(const SlicePass& pass, std::size_t light) {
    if (choices_[light].technique != Technique::map || visibilityOf(light)) return std::nullopt;
    const StageScope stage(pass.clock, FrameStage::map);
    const ShadowMapLookup map =
        maps_->draw(pass.scene, pass.view, pass.view.lights[light].light, visible_);
    vertexRuns_ += maps_->vertexRuns();
    glViewport(0, 0, pass.view.width, pass.view.height);
    glDisable(GL_STENCIL_TEST);
    return map;
}

void Renderer::chooseTechniques(const GpuScene& scene, const FrameView& view) {
    const ShadowPolicy policy = policyFor(sceneFactsOf(scene));
    choices_.clear();
    for (const FrameLight& of : view.lights)
        choices_.push_back(policy.choose(lightFactsOf(of), lookupFactsOf(scene, of)));
}

Technique Renderer::countedFor(std::size_t light) const {
    return visibilityOf(light) ? Technique::none : choices_[light].counted;
}

const GpuPrimitiveMap* Renderer::primitiveMapOf(const GpuScene& scene, const FrameView& view,
                                                std::size_t light) const {
    if (choices_[light].technique != Technique::lookup) return nullptr;
    return scene.primitiveMaps.of(view.lights[light].light)->map.get();
}

const GpuPrimitiveMap* Renderer::anyPrimitiveMapOf(const GpuScene& scene,
                                                   const Light& light) const {
    if (!settings_.records()) return nullptr;
    const PrimitiveMapState* state = scene.primitiveMaps.of(light);
    return state && state->map && !state->map->extended ? state->map.get() : nullptr;
}

const VisibilityLookup* Renderer::visibilityOf(std::size_t light) const {
    return light < visibility_.size() && visibility_[light].texture != 0 ? &visibility_[light]
                                                                         : nullptr;
}

SurfaceShading Renderer::shadingOf(const SlicePass& pass, std::optional<std::size_t> index) const {
    SurfaceShading shading;
    shading.mask = pass.view.mask;
    shading.farthest = static_cast<float>(pass.slice.far * sliceOverlap);
    shading.ambient = settings_.ambient;
    shading.background = settings_.background;
    shading.lights = sum_.lights;
    if (sum_.full) setFull(pass, shading);
    if (!index) return shading;
    const FrameLight& of = pass.view.lights[*index];
    const Light& light = of.light;
    shading.light = light;
    // So that what looks up, straight into all lights, is shown as it is.
    const float ambient = shading.ambient * (shading.full ? 1.0f + neutralSlope : 1.0f);
    const auto weight = static_cast<float>(of.weight);
    const float share =
        std::max(1.0f - ambient, 0.0f) * weight / static_cast<float>(shading.lights);
    shading.weight = of.weight;
    shading.diffuse = share;
    if (shading.full) {
        shading.full->lightColor =
            light.color * (light.photometric ? weight * std::numbers::inv_pi_v<float> : share);
        shading.diffuse = shading.full->lightColor.r;
    }
    shading.withAmbient = sum_.replaces;
    shading.visibility = visibilityOf(*index);
    shading.primitives =
        shading.visibility ? nullptr : primitiveMapOf(pass.scene, pass.view, *index);
    if (of.atOnce) shading.places = of.points;
    shading.eye = pass.view.frustum.eye();
    shading.tintPrimitives = settings_.tintPrimitives && !pass.view.mask;
    shading.selfShadowed = planar_ && shading.mask && !shading.visibility;
    shading.maskValue = pass.view.sumsMasks ? 1.0f / static_cast<float>(mostSummed) : 1.0f;
    return shading;
}

void Renderer::setFull(const SlicePass& pass, SurfaceShading& shading) const {
    FullShading& full = shading.full.emplace();
    full.plainIsShort = sum_.plainIsShort;
    full.environment = environment_ ? &*environment_ : nullptr;
    full.softTerminator = settings_.softTerminator;
    full.linear = sum_.linear;
    full.exposure = std::exp2(settings_.exposure);
    shading.ambient = lightShown(settings_.ambient);
    full.ambientSlope = neutralSlope * shading.ambient;
    full.eye = eyeFrom(pass.view.frustum);
}

void Renderer::drawLit(const SlicePass& pass, std::size_t light, const ShadowMapLookup* map) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    SurfaceShading shading = shadingOf(pass, light);
    shading.map = map;
    CoarseMaskLookup mask;
    if (coarse_ && !shading.primitives && !shading.visibility) {
        mask = coarse_->lookup(pass.view, pass.slice, pass.view.lights[light].light);
        shading.coarse = &mask;
    }
    drawSurfaces(pass.scene, pass.view, pass.slice, shading);
}

void Renderer::restoreAlpha(const GpuScene& scene, const FrameView& view) {
    mark_.clear();
    if (!view.mask) return;
    // A mask's alpha says where surfaces are.
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    SurfaceShading shading;
    shading.mask = true;
    const DepthSlice whole{view.near(), std::numeric_limits<double>::infinity()};
    drawSurfaces(scene, view, whole, shading);
}

} // namespace edgeshade
