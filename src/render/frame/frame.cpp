#include "src/render/frame/frame.hpp"

#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/frame/pass_state.hpp"
#include "src/render/volumes/stencil_count.hpp"
#include "src/scene/shadow_facts.hpp"
#include "src/settings/build_parts.hpp"
#include "src/shadow/plan/light_lists.hpp"
#include "src/shadow/view/light_reach.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

/// Records of the lists that a step of planning ahead makes: some 15 ms in a page.
constexpr std::size_t mostListedAhead = std::size_t{1} << 15;

bool isFullyShadowed(const LightPlan& light) {
    return std::any_of(light.counts.begin(), light.counts.end(),
                       [](const CountPlan& count) { return count.fullyShadowed; });
}

} // namespace

SidesLayout bestLayout(const gl::Capabilities& capabilities) {
    return capabilities.instancing ? SidesLayout::instanced : SidesLayout::notInstanced;
}

Renderer::Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : settings_(settings), capabilities_(capabilities), device_(deviceFactsOf(capabilities)),
      techniques_(settings, capabilities), surfaces_(capabilities) {
    if (settings.shading == Shading::full && LinearTarget::isPossible(capabilities))
        linear_.emplace(capabilities);
    if constexpr (listsLights)
        if (LightTable::isPossible(capabilities)) table_.emplace(capabilities);
    if (settings.records() && settings.maskScale > 1)
        coarse_.emplace(settings.maskScale, capabilities);
}

void Renderer::draw(GpuScene& scene, const FrameView& view, StageClock* clock,
                    std::span<const VisibilityLookup> visibility) {
    vertexRuns_ = 0;
    const gl::ScissorScope cut(view.part);
    const gl::Name framebuffer = gl::boundFramebuffer();
    beginFrame({scene, view, clock, nearnessOf(scene)}, visibility);
    prepareSum(scene, view);
    withTask(scene, view, [&](const FrameTask& task) { planFrame(task, scene, view, clock); });
    drawSlices(scene, view, clock);
    if (sum_.linear) linear_->show(framebuffer);
}

bool Renderer::planAhead(GpuScene& scene, const FrameView& view) {
    const gl::ScissorScope cut(view.part);
    const auto listed = [&] {
        const PotentialSilhouettes* lists = volumes() ? volumes()->silhouettes() : nullptr;
        return lists ? lists->made() : 0;
    };
    const std::size_t known = listed();
    beginFrame({scene, view, nullptr, nearnessOf(scene), mostListedAhead}, {});
    withTask(scene, view, [&](const FrameTask& task) { edgeshade::planFrame(task, plan_); });
    if (listed() != known) return false;
    prepare(plan_, scene, view);
    return true;
}

std::function<void(const FrameView&)> Renderer::nearnessOf(GpuScene& scene) {
    return [this, &scene](const FrameView& view) { drawNearness(scene, view); };
}

void Renderer::beginFrame(const FrameStart& start, std::span<const VisibilityLookup> visibility) {
    const FrameView& view = start.view;
    visibility_.assign(visibility.begin(), visibility.end());
    if (coarse_) {
        const gl::FramebufferKeeper keeper;
        coarse_->fit(view.width, view.height);
    }
    techniques_.forEach([&](ShadowTechnique& technique) { technique.beginFrame(start); });
    chooseTechniques(start.scene, view);
    sum_ = lightSum(start.scene, view);
}

void Renderer::beginMaskPrograms(std::span<const Light> lights, bool orthographic, bool nearness,
                                 bool open) {
    bool directional = false;
    surfaces_.beginProgram(maskVariantOf({}));
    for (const Light& light : lights) {
        surfaces_.beginProgram(maskVariantOf(light));
        directional = directional || light.position.w == 0.0;
    }
    if (nearness) surfaces_.beginProgram(nearnessVariant(orthographic));
    mark_.beginPrograms();
    techniques_.forEach([&](ShadowTechnique& of) { of.beginPrograms(directional, open); });
}

void Renderer::forEachProgram(const gl::ProgramVisitor& visit) const {
    surfaces_.forEachProgram(visit);
    mark_.forEachProgram(visit);
    techniques_.forEach([&](const ShadowTechnique& of) { of.forEachProgram(visit); });
}

void Renderer::drawSlices(GpuScene& scene, const FrameView& view, StageClock* clock) {
    glViewport(0, 0, view.width, view.height);
    glDisable(GL_CULL_FACE);
    bool marked = false;
    for (std::size_t s = 0; s < view.slices.size(); ++s) {
        const SlicePass pass{scene, view, view.slices[s], plan_.slices[s], s == 0, clock};
        if (marked) mark_.clear(); // the light with ambient light keeps their share in alpha
        drawDepthAndAmbient(pass);
        techniques_.forEach([](ShadowTechnique& technique) { technique.beginSlice(); });
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

void Renderer::withTask(GpuScene& scene, const FrameView& view,
                        FunctionRef<void(const FrameTask&)> use) {
    const auto groupCount = [&](std::size_t light) {
        const ShadowTechnique* marking = markingOf(light);
        return marking ? marking->stencils(scene, view.lights[light]) : 0;
    };
    const auto planCount = [&](const DepthSlice& slice, std::size_t light, std::size_t group,
                               CountPlan& plan) {
        markingOf(light)->plan(scene, castersOf(view, slice, light, group), plan);
    };
    const auto mayList = [&](std::size_t light) { return mayBeListed(view, light); };
    FrameTask task{.view = view,
                   .open = view.part ? intersection({0, 0, view.width, view.height}, *view.part)
                                     : gl::scissored(view.width, view.height),
                   .ownStencil = coarse_.has_value(),
                   .ambientApart = sum_.full && !sum_.replaces,
                   .groupCount = groupCount,
                   .planCount = planCount};
    if (!techniques_.any(&ShadowTechnique::marksEverywhere))
        task.open = intersection(task.open, visiblePixels(view));
    if constexpr (listsLights)
        if (table_) {
            task.mayBeListed = mayList;
            task.list = listLights;
        }
    use(task);
}

void Renderer::planFrame(const FrameTask& task, GpuScene& scene, const FrameView& view,
                         StageClock* clock) {
    if (!techniques_.any(&ShadowTechnique::countsInStencil))
        return edgeshade::planFrame(task, plan_);
    if (clock && clock->wantsSilhouette()) {
        const StageScope stage(clock, FrameStage::silhouette);
        edgeshade::planFrame(task, plan_);
        prepare(plan_, scene, view);
        countInOnePixel(plan_, scene, view);
    }
    const StageScope stage(clock, FrameStage::counting);
    edgeshade::planFrame(task, plan_);
    prepare(plan_, scene, view);
}

CasterGroupInSlice Renderer::castersOf(const FrameView& view, const DepthSlice& slice,
                                       std::size_t light, std::size_t group) const {
    return {view, slice, light, group,
            choices_[light].countsAnimatedAlone() || view.lights[light].animatedAlone};
}

template <class Use>
void Renderer::forEachStencil(const FramePlan& frame, const FrameView& view, Use use) {
    for (std::size_t s = 0; s < frame.slices.size(); ++s)
        for (std::size_t light = 0; light < frame.slices[s].lights.size(); ++light) {
            const auto& counts = frame.slices[s].lights[light].counts;
            for (std::size_t group = 0; group < counts.size(); ++group)
                use(*markingOf(light), counts[group],
                    castersOf(view, view.slices[s], light, group));
        }
}

void Renderer::prepare(const FramePlan& plan, GpuScene& scene, const FrameView& view) {
    forEachStencil(
        plan, view,
        [&](ShadowTechnique& marking, const CountPlan& count, const CasterGroupInSlice& casters) {
            marking.prepare(count, scene, casters);
        });
}

void Renderer::countInOnePixel(const FramePlan& plan, const GpuScene& scene,
                               const FrameView& view) {
    const gl::ScissorScope onePixel(PixelRectangle{0, 0, 1, 1});
    glDisable(GL_CULL_FACE);
    set(passes::counting);
    glViewport(0, 0, 1, 1);
    forEachStencil(plan, view,
                   [&](const ShadowTechnique& marking, const CountPlan& count,
                       const CasterGroupInSlice& casters) {
                       marking.countAlone({scene, count, casters, {}, {}});
                   });
}

void Renderer::drawDepthAndAmbient(const SlicePass& pass) {
    const std::optional<std::size_t> light = pass.plan.withAmbient ? pass.plan.first : std::nullopt;
    if (light) drawLookedUp(pass, *light);
    const StageScope stage(pass.clock, FrameStage::ambient);
    PassState state = passes::surfaces;
    set(state);
    if (pass.first) {
        const glm::vec4 clear =
            pass.view.mask ? glm::vec4(0.0f, 0.0f, 0.0f, pass.view.depthDrawn ? 1.0f : 0.0f)
            : sum_.linear  ? glm::vec4(LinearTarget::lightShownAs(settings_.background), 1.0f)
                           : glm::vec4(settings_.background, 1.0f);
        glClearColor(clear.r, clear.g, clear.b, clear.a);
    }
    // Clear depth and stencil together: clearing one alone is slow where they share bytes.
    setStencilClear(pass.plan.start());
    glClear((pass.view.depthDrawn ? 0 : GL_DEPTH_BUFFER_BIT) | GL_STENCIL_BUFFER_BIT |
            (pass.first ? GL_COLOR_BUFFER_BIT : 0));
    if (pass.view.depthDrawn) return;

    SurfaceShading shading = shadingOf(pass, light);
    if (light) {
        shading.withAmbient = true;
        shading.map = mapOf(*light);
        // Only counted shadows need the share in alpha; without them alpha stays 1.
        const bool counted = pass.plan.lights[*light].isCounted();
        state.color[3] = counted && sum_.darkens();
        set(state);
    }
    drawSurfaces(pass.scene, pass.view, pass.slice, shading);
}

void Renderer::drawShadow(const SlicePass& pass) {
    const gl::ScissorScope cut(pass.plan.lights[*pass.plan.first].reach, pass.view.part);
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
    set(passes::ambientInShadow);
    drawSurfaces(pass.scene, pass.view, pass.slice, shadingOf(pass, {}));
}

void Renderer::drawShadowedLight(const SlicePass& pass, std::size_t light) {
    const LightPlan& plan = pass.plan.lights[light];
    const gl::ScissorScope cut(plan.reach, pass.view.part);
    drawLookedUp(pass, light);
    if (plan.isCounted()) {
        if (light == pass.plan.first)
            count(pass, light, 0);
        else
            countAndMark(pass, light);
    }
    if (!isFullyShadowed(plan)) addLight(pass, light);
    glDisable(GL_STENCIL_TEST);
}

/// Marks the light's shadow in the stencil; with groups or a lower resolution, in alpha.
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

void Renderer::count(const SlicePass& pass, std::size_t light, std::size_t group) {
    const StageScope stage(pass.clock, FrameStage::counting);
    const CountPlan& plan = pass.plan.lights[light].counts[group];
    set(passes::counting);
    vertexRuns_ +=
        markingOf(light)->mark({pass.scene, plan, castersOf(pass.view, pass.slice, light, group),
                                pass.plan.lights[light].reach, pass.plan.reach});
}

void Renderer::drawLookedUp(const SlicePass& pass, std::size_t light) {
    ShadowTechnique* technique = techniqueOf(light);
    if (!technique || !technique->drawsMap()) return;
    const StageScope stage(pass.clock, FrameStage::map);
    vertexRuns_ += technique->draw(pass.scene, pass.view, pass.view.lights[light].light);
    glViewport(0, 0, pass.view.width, pass.view.height);
    glDisable(GL_STENCIL_TEST);
}

void Renderer::chooseTechniques(const GpuScene& scene, const FrameView& view) {
    const ShadowPolicy policy = policyFor(sceneFactsOf(scene));
    choices_.clear();
    for (const FrameLight& of : view.lights)
        choices_.push_back(policy.choose(lightFactsOf(of), lookupFactsOf(scene, of)));
}

ShadowTechnique* Renderer::techniqueOf(std::size_t light) const {
    return visibilityOf(light) ? nullptr : techniques_.of(choices_[light].technique);
}

ShadowTechnique* Renderer::markingOf(std::size_t light) const {
    return visibilityOf(light) ? nullptr : techniques_.of(choices_[light].counted);
}

const ShadowMapLookup* Renderer::mapOf(std::size_t light) const {
    const ShadowTechnique* technique = techniqueOf(light);
    return technique ? technique->map() : nullptr;
}

const VisibilityLookup* Renderer::visibilityOf(std::size_t light) const {
    return light < visibility_.size() && visibility_[light].texture != 0 ? &visibility_[light]
                                                                         : nullptr;
}

} // namespace edgeshade
