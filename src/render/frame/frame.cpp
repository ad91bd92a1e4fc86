#include "src/render/frame/frame.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/volumes/stencil_count.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

/// Neighbouring slices share a thin layer of surfaces, so that rounding leaves no gap between them.
constexpr double sliceOverlap = 1.0001;

/// Published records are counted behind surfaces alone, where a far plane at a finite depth cuts
/// volumes (docs/method.md, C33).
void requireCountable(const RenderSettings& settings, const FrameView& view) {
    const auto records = settings.records();
    if (view.frustum.orthographic && records && records->volumes == VolumeLayout::published)
        throw Error(ExitStatus::unavailable,
                    "Published records can't be counted in an orthographic picture; "
                    "'--multiplicity plane' can.");
}

/// How far away a point is, for what is drawn from far to near.
double distanceFrom(const Frustum& frustum, const glm::dvec3& point) {
    return frustum.orthographic ? depthOf(frustum, point)
                                : glm::distance(frustum.position(), point);
}

VolumesOfBatch volumesOfScene(const GpuScene& scene) {
    return
        [&scene](std::size_t batch) -> const BatchVolumes& { return scene.batches[batch].volumes; };
}

} // namespace

SidesLayout bestLayout(const gl::Capabilities& capabilities) {
    return capabilities.instancing ? SidesLayout::instanced : SidesLayout::notInstanced;
}

Renderer::Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : settings_(settings), counter_(settings, capabilities), surfaces_(settings.map.pcf) {
    if (settings.shadows == ShadowMethod::map) maps_.emplace(settings.map, capabilities);
    if (settings.records() && settings.maskScale > 1)
        coarse_.emplace(settings.maskScale, capabilities);
}

void Renderer::draw(const GpuScene& scene, const FrameView& view, StageClock* clock) {
    vertexRuns_ = 0;
    requireCountable(settings_, view);
    counter_.beginFrame(scene);
    glm::ivec2 counted(view.width, view.height);
    if (coarse_) {
        const gl::FramebufferKeeper keeper;
        coarse_->fit(view.width, view.height);
        counted = coarse_->size();
    }
    glViewport(0, 0, view.width, view.height);
    glDisable(GL_CULL_FACE); // every caster must be in the depth buffer, from both sides
    glEnable(GL_DEPTH_TEST);
    const std::size_t lights = view.mask ? 1 : view.lights.size();
    PixelRectangle open = gl::scissored(view.width, view.height);
    if (cutsToVisible()) open = intersection(open, visiblePixels(view));
    bool marked = false;
    for (std::size_t s = 0; s < view.slices.size(); ++s) {
        const Pass pass{scene, view, view.slices[s], s == 0, clock, counted};
        std::vector<PixelRectangle> reaches(lights); // empty: nothing to draw
        PixelRectangle reach;
        for (std::size_t i = 0; i < lights; ++i) {
            if (!view.lights[i].drawn) continue;
            reaches[i] = intersection(open, lightReach(view, pass.slice, view.lights[i].light));
            reach = united(reach, reaches[i]);
        }
        if (marked) mark_.clear(); // the light with ambient light has its share in alpha
        const auto first = firstByItself(pass, reaches);
        std::optional<PreparedCount> prepared;
        if (first && settings_.shadows == ShadowMethod::volumes)
            prepared = prepareCount(pass, *first, volumesOfScene(scene));
        const bool withAmbient = first && !view.mask;
        drawDepthAndAmbient(pass, withAmbient ? &view.lights[*first].light : nullptr,
                            prepared ? prepared->cleared() : 0);
        if (coarse_ && !reach.empty()) drawCoarseSurfaces(pass, reach);
        if (withAmbient && prepared) drawShadow(pass, reaches[*first], *prepared);
        for (std::size_t i = 0; i < lights; ++i) {
            if (reaches[i].empty() || (withAmbient && i == *first)) continue;
            const GroupedShadow* grouped = groupsOf(pass, i);
            drawShadowedLight(pass, i, grouped, reaches[i],
                              i == first && prepared ? &*prepared : nullptr);
            marked = marked || (grouped && !coarse_);
        }
        if (!view.mask && view.drawBlended) drawBlended(pass);
    }
    if (marked) restoreAlpha(scene, view);
}

std::size_t Renderer::drawSurfaces(const Pass& pass, const SurfaceShading& shading) {
    std::size_t runs = 0;
    const glm::dvec3 eye = pass.view.frustum.position();
    for (const GpuBatch& batch : pass.scene.batches) {
        if (batch.hidden) continue;
        BatchView batchView = batchViewOf(batch, pass.view, pass.slice);
        if (shading.map)
            batchView.mapFromObject = glm::mat4(shading.map->mapFromWorld * batch.worldFromBatch);
        for (const AlphaMode kind : {AlphaMode::opaque, AlphaMode::mask})
            runs += surfaces_.draw(pass.scene, batch, batchView, eye, shading, kind);
    }
    return runs;
}

bool Renderer::cutsToVisible() const {
    const auto records = settings_.records();
    return !records || records->volumes != VolumeLayout::published;
}

const GroupedShadow* Renderer::groupsOf(const Pass& pass, std::size_t light) const {
    const auto records = settings_.records();
    return records ? pass.scene.groups.of(pass.view.lights[light], records->volumes)
                   : nullptr;
}

std::optional<std::size_t>
Renderer::firstByItself(const Pass& pass, const std::vector<PixelRectangle>& reaches) const {
    if (coarse_) return std::nullopt;
    for (std::size_t i = 0; i < reaches.size(); ++i)
        if (!reaches[i].empty() && !groupsOf(pass, i)) return i;
    return std::nullopt;
}

void Renderer::drawDepthAndAmbient(const Pass& pass, const Light* light, int stencil) {
    std::optional<ShadowMapLookup> map;
    if (light && settings_.shadows == ShadowMethod::map) map = drawMap(pass, *light);
    const StageScope stage(pass.clock, FrameStage::ambient);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    if (pass.first) {
        const glm::vec4 clear =
            pass.view.mask ? glm::vec4(0.0f) : glm::vec4(settings_.background, 1.0f);
        glClearColor(clear.r, clear.g, clear.b, clear.a);
    }
    // Depth and stencil at once: one without the other is dear where they share their bytes.
    glStencilMask(0xFF);
    glClearStencil(stencil & 0xFF);
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | (pass.first ? GL_COLOR_BUFFER_BIT : 0));

    SurfaceShading shading = shadingOf(pass, light);
    if (light) {
        shading.withAmbient = true;
        shading.map = map ? &*map : nullptr;
        // Alpha, which is 1, is the volumes'.
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, settings_.shadows == ShadowMethod::volumes);
    }
    shading.ambient = settings_.ambient;
    drawSurfaces(pass, shading);
}

void Renderer::drawShadow(const Pass& pass, const PixelRectangle& reach,
                          const PreparedCount& prepared) {
    const gl::ScissorScope cut(reach);
    count(pass, prepared);
    const StageScope stage(pass.clock, FrameStage::lit);
    mark_.darkenCounted();
    mark_.clear();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_STENCIL_TEST);
}

/// Depth and planes of what is visible, for the masks of all lights.
void Renderer::drawCoarseSurfaces(const Pass& pass, const PixelRectangle& reach) {
    const StageScope stage(pass.clock, FrameStage::volumes);
    const gl::FramebufferKeeper keeper;
    coarse_->bindSurfaces();
    const gl::ScissorScope cut(scaledReach(reach, pass.view, coarse_->size()));
    glDisable(GL_DITHER); // the bytes are no colour
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const PlaneSpace planes = coarse_->space(pass.view, pass.slice);
    SurfaceShading shading = shadingOf(pass, nullptr);
    shading.planes = &planes;
    vertexRuns_ += drawSurfaces(pass, shading);
    glEnable(GL_DITHER);
    glViewport(0, 0, pass.view.width, pass.view.height);
}

void Renderer::drawShadowedLight(const Pass& pass, std::size_t lightIndex,
                                 const GroupedShadow* groups, const PixelRectangle& reach,
                                 const PreparedCount* prepared) {
    const Light& light = pass.view.lights[lightIndex].light;
    const gl::ScissorScope cut(reach);
    std::optional<ShadowMapLookup> map;
    if (settings_.shadows == ShadowMethod::map) map = drawMap(pass, light);
    if (prepared) {
        count(pass, *prepared);
        if (prepared->sealed) return;
    } else if (settings_.shadows == ShadowMethod::volumes) {
        if (!countAndMark(pass, lightIndex, groups, reach)) return;
    }

    const StageScope stage(pass.clock, FrameStage::lit);
    glEnable(GL_BLEND);
    const bool counted = settings_.shadows == ShadowMethod::volumes && !coarse_ && !groups;
    if (!counted) clearStencil(0);
    if (groups && !coarse_) // what a group has shaded has alpha 0 and takes no light
        glBlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    else
        glBlendFunc(GL_ONE, GL_ONE);
    // Of surfaces that coincide the first is lit, as it is by ambient light.
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 0, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    drawLit(pass, light, map ? &*map : nullptr);
    glDisable(GL_STENCIL_TEST);
}

/// Leaves what is in shadow in the stencil; where there are groups or a lower resolution, in alpha.
/// False if that is certainly everything.
bool Renderer::countAndMark(const Pass& pass, std::size_t light, const GroupedShadow* groups,
                            const PixelRectangle& reach) {
    std::optional<gl::FramebufferKeeper> keeper;
    std::optional<gl::ScissorScope> cut;
    if (coarse_) {
        keeper.emplace();
        coarse_->bindCounts();
        cut.emplace(scaledReach(reach, pass.view, coarse_->size()));
    }
    bool open = true;
    const bool marks = groups || coarse_;
    if (marks) mark_.clear();
    const auto countThem = [&](const VolumesOfBatch& volumesOf) {
        const PreparedCount prepared = prepareCount(pass, light, volumesOf);
        clearStencil(prepared.cleared());
        count(pass, prepared);
        open = !prepared.sealed && open;
        if (marks) mark_.markCounted();
    };
    if (groups) {
        for (const auto& group : *groups)
            countThem([&](std::size_t b) -> const BatchVolumes& { return group[b]; });
    } else {
        countThem(volumesOfScene(pass.scene));
    }
    if (coarse_) glViewport(0, 0, pass.view.width, pass.view.height);
    return open;
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

/// Where the clock asks for it, counts once more into one pixel, which leaves the stencil in
/// disorder.
PreparedCount Renderer::prepareCount(const Pass& pass, std::size_t light,
                                     const VolumesOfBatch& volumesOf) {
    const CountTask task{pass.scene, pass.view, pass.slice, light, volumesOf};
    if (pass.clock && pass.clock->wantsSilhouette()) {
        const StageScope stage(pass.clock, FrameStage::silhouette);
        const gl::ScissorScope onePixel({0, 0, 1, 1});
        setCounting();
        glViewport(0, 0, 1, 1);
        counter_.count(counter_.prepare(task), pass.scene);
        glViewport(0, 0, pass.counted.x, pass.counted.y);
    }
    const StageScope stage(pass.clock, FrameStage::volumes);
    return counter_.prepare(task);
}

void Renderer::count(const Pass& pass, const PreparedCount& prepared) {
    const StageScope stage(pass.clock, FrameStage::volumes);
    setCounting();
    counter_.count(prepared, pass.scene);
    vertexRuns_ += prepared.vertexRuns;
}

ShadowMapLookup Renderer::drawMap(const Pass& pass, const Light& light) {
    const StageScope stage(pass.clock, FrameStage::map);
    const ShadowMapLookup map = maps_->draw(pass.scene, pass.view.bounds, light);
    vertexRuns_ += maps_->vertexRuns();
    glViewport(0, 0, pass.view.width, pass.view.height);
    glDisable(GL_STENCIL_TEST);
    return map;
}

SurfaceShading Renderer::shadingOf(const Pass& pass, const Light* light) const {
    SurfaceShading shading;
    shading.mask = pass.view.mask;
    shading.farthest = static_cast<float>(pass.slice.far * sliceOverlap);
    if (!light) return shading;
    shading.light = *light;
    shading.diffuse = (1.0f - settings_.ambient) / static_cast<float>(pass.view.lights.size());
    shading.maskValue = 1.0f;
    return shading;
}

void Renderer::drawLit(const Pass& pass, const Light& light, const ShadowMapLookup* map) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    SurfaceShading shading = shadingOf(pass, &light);
    shading.map = map;
    CoarseMaskLookup mask;
    if (coarse_) {
        mask = coarse_->lookup(pass.view, pass.slice, light);
        shading.coarse = &mask;
    }
    drawSurfaces(pass, shading);
}

void Renderer::drawBlended(const Pass& pass) {
    struct Item {
        double distance;
        const SurfaceChunk* chunk;
        BatchView view;
    };
    std::vector<Item> items;
    for (const GpuBatch& batch : pass.scene.batches)
        for (const SurfaceChunk& chunk : batch.surfaces) {
            const bool blends = pass.scene.materials[chunk.material].alphaMode == AlphaMode::blend;
            if (!blends || batch.hidden) continue;
            const glm::dvec3 center(batch.worldFromBatch * glm::dvec4(chunk.center, 1.0));
            items.push_back({distanceFrom(pass.view.frustum, center), &chunk,
                             batchViewOf(batch, pass.view, pass.slice)});
        }
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return a.distance > b.distance; });

    if (items.empty()) return;
    const StageScope stage(pass.clock, FrameStage::lit);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    SurfaceShading shading;
    shading.ambient = 1.0f; // what is see-through takes no part in shadows
    shading.farthest = static_cast<float>(pass.slice.far);
    for (const Item& item : items)
        surfaces_.drawChunk(pass.scene, *item.chunk, item.view, pass.view.frustum.position(),
                            shading);
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
    drawSurfaces({scene, view, whole, false}, shading);
}

} // namespace edgeshade
