// Renderer: see-through surfaces.

#include "src/render/drawing/cull_scope.hpp"
#include "src/render/frame/frame.hpp"
#include "src/render/frame/pass_state.hpp"
#include "src/scene/shadow_facts.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

/// A point's distance, for drawing from far to near.
double distanceFrom(const Frustum& frustum, const glm::dvec3& point) {
    return frustum.orthographic ? depthOf(frustum, point)
                                : glm::distance(frustum.position(), point);
}

} // namespace

void Renderer::drawBlended(const SlicePass& pass) {
    struct Item {
        double distance;
        const SurfaceChunk* chunk;
        const GpuBatch* batch;
    };
    std::vector<Item> items;
    for (const GpuBatch& batch : pass.scene.batches)
        for (const SurfaceChunk& chunk : *batch.surfaces) {
            const bool blends = pass.scene.materials[chunk.material].isSeeThrough();
            if (!blends || batch.hidden) continue;
            const glm::dvec3 center(batch.worldFromBatch * glm::dvec4(chunk.center, 1.0));
            items.push_back({distanceFrom(pass.view.frustum, center), &chunk, &batch});
        }
    if (items.empty()) return;
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return a.distance > b.distance; });

    const StageScope stage(pass.clock, FrameStage::lit);
    set(passes::seeThrough(false, true)); // chunks change only the blending
    for (const Item& item : items) {
        const Material& material = pass.scene.materials[item.chunk->material];
        const bool mirrored = item.batch->mirrored();
        if (!sum_.full) {
            const CullScope frontAlone(pass.view.culls && !material.doubleSided, mirrored);
            drawAsInFullLight(pass, *item.batch, *item.chunk);
            continue;
        }
        // Draw back faces before front faces, if there are any: the triangles' order in the chunk
        // says nothing about their depth.
        for (const bool fromBehind : {true, false}) {
            if (fromBehind && !material.doubleSided) continue;
            const CullScope leftOut(fromBehind == mirrored ? GL_BACK : GL_FRONT);
            if (material.unlit)
                drawAsInFullLight(pass, *item.batch, *item.chunk);
            else
                drawSeeThrough(pass, *item.batch, *item.chunk);
        }
    }
}

void Renderer::drawBlendedChunk(const SlicePass& pass, const GpuBatch& batch,
                                const SurfaceChunk& chunk, SurfaceShading shading) {
    shading.farthest = static_cast<float>(pass.slice.far);
    surfaces_.drawChunk(pass.scene, chunk,
                        surfaceViewOf(pass.scene, batch, pass.view, pass.slice, shading), shading);
}

void Renderer::drawAsInFullLight(const SlicePass& pass, const GpuBatch& batch,
                                 const SurfaceChunk& chunk) {
    set(passes::seeThroughBlend(false, false));
    SurfaceShading shading = shadingOf(pass, {});
    shading.ambient = 1.0f;
    drawBlendedChunk(pass, batch, chunk, shading);
}

void Renderer::drawSeeThrough(const SlicePass& pass, const GpuBatch& batch,
                              const SurfaceChunk& chunk) {
    set(passes::seeThroughBlend(false, true));
    bool first = true;
    for (std::size_t i = 0; i < pass.view.lights.size(); ++i) {
        const FrameLight& light = pass.view.lights[i];
        const LightPlan& plan = pass.plan.lights[i];
        if (!light.drawn || plan.listed || plan.reach.empty()) continue;
        SurfaceShading shading = shadingOf(pass, i);
        shading.visibility = nullptr; // it belongs to the surface behind
        // Whatever the light's technique is: the stencil does not count for see-through surfaces.
        const bool lookedUp =
            light.shadowed && techniques_.volumes() && lookupFactsOf(pass.scene, light).isUsable;
        shading.primitives = lookedUp ? pass.scene.primitiveMaps.mapOf(light.light) : nullptr;
        shading.withAmbient = first;
        drawBlendedChunk(pass, batch, chunk, shading);
        first = false;
        set(passes::seeThroughBlend(true, true));
    }
    if (first) drawBlendedChunk(pass, batch, chunk, shadingOf(pass, {}));
    if (!pass.plan.lists) return;
    set(passes::seeThroughBlend(true, true));
    drawBlendedChunk(pass, batch, chunk, listedShading(pass));
}

} // namespace edgeshade
