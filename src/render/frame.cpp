#include "src/render/frame.hpp"

#include "preprocess/error.hpp"

#include <algorithm>
#include <GLES2/gl2.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace edgeshade {
namespace {

BatchView viewOf(const GpuBatch& batch, const FrameView& view) {
    const double aspect = static_cast<double>(view.width) / view.height;
    const glm::dmat4 clipFromWorld =
        clipFromView(view.camera, aspect, view.near) * viewFromWorld(view.camera);
    BatchView result;
    result.clipFromObject = glm::mat4(clipFromWorld * batch.worldFromBatch);
    result.eyeOffsetFromObject =
        glm::mat4(glm::translate(glm::dmat4(1.0), -view.camera.from) * batch.worldFromBatch);
    result.normalFromObject = glm::mat3(glm::inverseTranspose(glm::dmat3(batch.worldFromBatch)));
    result.mirrored = batch.mirrored();
    return result;
}

const gl::Capabilities& requireInstancing(const RenderSettings& settings,
                                          const gl::Capabilities& capabilities) {
    if (settings.layout != SidesLayout::notInstanced && !capabilities.instancing)
        throw Error(ExitStatus::unavailable,
                    "This GL has no instanced drawing; '--instancing off' does without.");
    return capabilities;
}

} // namespace

SidesLayout bestLayout(const gl::Capabilities& capabilities) {
    return capabilities.instancing ? SidesLayout::instanced : SidesLayout::notInstanced;
}

Renderer::Renderer(const RenderSettings& settings, const gl::Capabilities& capabilities)
    : settings_(settings), surfaces_(settings.map.pcf),
      sides_(settings.multiplicity, settings.layout,
             requireInstancing(settings, capabilities).instancing),
      caps_(settings.multiplicity, settings.layout, capabilities.instancing) {
    if (settings.shadows == ShadowMethod::map) maps_.emplace(settings.map, capabilities);
}

void Renderer::draw(const GpuScene& scene, const FrameView& view) {
    glViewport(0, 0, view.width, view.height);
    glDisable(GL_CULL_FACE); // every caster must be in the depth buffer, from both sides
    glEnable(GL_DEPTH_TEST);
    drawDepthAndAmbient(scene, view);
    const std::size_t lights = settings_.mask ? 1 : view.lights.size();
    for (std::size_t i = 0; i < lights; ++i) {
        const Light& light = view.lights[i];
        std::optional<ShadowMapLookup> map;
        if (settings_.shadows == ShadowMethod::volumes) drawVolumes(scene, view, light);
        if (settings_.shadows == ShadowMethod::map) map = drawMap(scene, view, light);
        drawLit(scene, view, light, map ? &*map : nullptr);
    }
    if (!settings_.mask) drawBlended(scene, view);
}

void Renderer::drawDepthAndAmbient(const GpuScene& scene, const FrameView& view) {
    const glm::vec4 clear =
        settings_.mask ? glm::vec4(0.0f) : glm::vec4(settings_.background, 1.0f);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glClearColor(clear.r, clear.g, clear.b, clear.a);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    SurfaceShading shading;
    shading.ambient = settings_.ambient;
    shading.mask = settings_.mask;
    for (const GpuBatch& batch : scene.batches)
        for (const AlphaMode kind : {AlphaMode::opaque, AlphaMode::mask})
            surfaces_.draw(scene, batch, viewOf(batch, view), view.camera.from, shading, kind);
}

void Renderer::drawVolumes(const GpuScene& scene, const FrameView& view, const Light& light) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(0xFF);
    glClearStencil(0);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilFunc(GL_ALWAYS, 0, 0xFF);
    for (std::size_t i = 0; i < scene.batches.size(); ++i) {
        const GpuBatch& batch = scene.batches[i];
        const BatchView batchView = viewOf(batch, view);
        // A mirroring transform turns every winding over.
        const GLenum front = batchView.mirrored ? GL_BACK : GL_FRONT;
        const GLenum back = batchView.mirrored ? GL_FRONT : GL_BACK;
        glStencilOpSeparate(front, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
        glStencilOpSeparate(back, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
        const glm::vec4 lightHere = lightInObject(light, batch.worldFromBatch);
        sides_.draw(batch.shadow, lightHere, batchView.clipFromObject);
        const bool nearDiscard = view.nearestDepths[i] <= view.near;
        caps_.draw(batch.shadow, scene.materials, scene.textures, lightHere,
                   batchView.clipFromObject, nearDiscard);
    }
}

ShadowMapLookup Renderer::drawMap(const GpuScene& scene, const FrameView& view,
                                  const Light& light) {
    const ShadowMapLookup map = maps_->draw(scene, view.bounds, light);
    glViewport(0, 0, view.width, view.height);
    return map;
}

void Renderer::drawLit(const GpuScene& scene, const FrameView& view, const Light& light,
                       const ShadowMapLookup* map) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    if (settings_.shadows == ShadowMethod::volumes) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_EQUAL, 0, 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }
    SurfaceShading shading;
    shading.light = light;
    shading.diffuse = (1.0f - settings_.ambient) / static_cast<float>(view.lights.size());
    shading.mask = settings_.mask;
    shading.maskValue = 1.0f;
    shading.map = map;
    for (const GpuBatch& batch : scene.batches) {
        BatchView batchView = viewOf(batch, view);
        if (map) batchView.mapFromObject = glm::mat4(map->mapFromWorld * batch.worldFromBatch);
        for (const AlphaMode kind : {AlphaMode::opaque, AlphaMode::mask})
            surfaces_.draw(scene, batch, batchView, view.camera.from, shading, kind);
    }
}

void Renderer::drawBlended(const GpuScene& scene, const FrameView& view) {
    struct Item {
        double distance;
        const SurfaceChunk* chunk;
        BatchView view;
    };
    std::vector<Item> items;
    for (const GpuBatch& batch : scene.batches)
        for (const SurfaceChunk& chunk : batch.surfaces) {
            if (scene.materials[chunk.material].alphaMode != AlphaMode::blend) continue;
            const glm::dvec3 center(batch.worldFromBatch * glm::dvec4(chunk.center, 1.0));
            items.push_back({glm::distance(center, view.camera.from), &chunk, viewOf(batch, view)});
        }
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return a.distance > b.distance; });

    glDisable(GL_STENCIL_TEST);
    glDepthFunc(GL_LESS);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    SurfaceShading shading;
    shading.ambient = 1.0f; // what is see-through takes no part in shadows
    for (const Item& item : items)
        surfaces_.drawChunk(scene, *item.chunk, item.view, view.camera.from, shading);
}

} // namespace edgeshade
