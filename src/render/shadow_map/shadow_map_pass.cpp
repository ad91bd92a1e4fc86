#include "src/render/shadow_map/shadow_map_pass.hpp"

#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/shadow_map/pcss_view.hpp"

#include <algorithm>
#include <cstddef>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

bool hasSurfaces(const GpuScene& scene) {
    return std::any_of(scene.batches.begin(), scene.batches.end(),
                       [](const GpuBatch& batch) { return !batch.surfaces->empty(); });
}

} // namespace

ShadowMapPass::ShadowMapPass(const ShadowMapSettings& settings,
                             const gl::Capabilities& capabilities)
    : settings_(settings), capabilities_(capabilities) {
    requireMapSize(settings.size, capabilities);
}

const ShadowMapTarget& ShadowMapPass::target(ShadowMapKind kind) {
    auto found = targets_.find(kind);
    if (found == targets_.end())
        found = targets_.emplace(kind, ShadowMapTarget(kind, settings_.size, capabilities_)).first;
    return found->second;
}

gl::Program& ShadowMapPass::program(const Variant& variant) {
    auto found = programs_.find(variant);
    if (found == programs_.end()) {
        std::vector<std::string> defines;
        if (variant.kind == ShadowMapKind::directional) defines.push_back("MAP_DIRECTIONAL");
        if (variant.alphaTest) defines.push_back("ALPHA_TEST");
        found =
            programs_
                .emplace(variant, gl::Program(shaders::shadow_map_vert, shaders::shadow_map_frag,
                                              defines, {"a_position", "a_texcoord", "a_color"}))
                .first;
    }
    return found->second;
}

ShadowMapLookup ShadowMapPass::draw(const GpuScene& scene, const Box& bounds, const Light& light) {
    if (bounds.empty() && hasSurfaces(scene))
        throw Error(ExitStatus::unavailable,
                    "A shadow map needs the scene's bounds, and this view has none.");
    const gl::FramebufferKeeper keeper;
    const ShadowMapKind kind = light.position.w == 0.0 ? ShadowMapKind::directional
                               : settings_.facesApart  ? ShadowMapKind::pointApart
                                                       : ShadowMapKind::point;
    const ShadowMapTarget& map = target(kind);
    const Box fitted = bounds.empty() ? Box{glm::dvec3(0.0), glm::dvec3(0.0)} : bounds;
    const ShadowMapView view = shadowMapView(light, fitted, settings_, map.depthBits());
    Subject subject = subjectOf(scene, fitted, light);
    vertexRuns_ = 0;
    if (drawn_[kind] != subject) {
        drawFaces(scene, view, map);
        drawn_[kind] = std::move(subject);
    }
    ShadowMapLookup lookup{map.kind(),
                           map.textures(),
                           view.mapFromWorld,
                           static_cast<float>(view.step),
                           static_cast<float>(view.texel),
                           settings_.biasTexels};
    lookup.soft = settings_.soft != SoftShadows::none && light.extent;
    if (settings_.soft == SoftShadows::pcss && light.extent) lookup.pcss = pcssLight(light, view);
    return lookup;
}

ShadowMapPass::Subject ShadowMapPass::subjectOf(const GpuScene& scene, const Box& bounds,
                                                const Light& light) {
    Subject subject{scene.identity,   light.position, light.range, bounds.low, bounds.high, {},
                    scene.cutoutsCast};
    for (const GpuBatch& batch : scene.batches)
        subject.batches.emplace_back(batch.worldFromBatch, batch.hidden);
    return subject;
}

void ShadowMapPass::drawFaces(const GpuScene& scene, const ShadowMapView& view,
                              const ShadowMapTarget& map) {
    glViewport(0, 0, settings_.size, settings_.size);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER); // the bytes are no colour
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    for (std::size_t face = 0; face < view.faces.size(); ++face) {
        map.bindFace(face);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (view.faces[face].seesScene) drawCasters(scene, view, view.faces[face].clipFromMap);
    }
    glEnable(GL_DITHER);
}

void ShadowMapPass::drawCasters(const GpuScene& scene, const ShadowMapView& view,
                                const glm::dmat4& clipFromMap) {
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden) continue;
        const glm::dmat4 mapFromObject = view.mapFromWorld * batch.worldFromBatch;
        for (const SurfaceChunk& chunk : *batch.surfaces) {
            const Material& material = scene.materials[chunk.material];
            if (!scene.castsInMaps(material)) continue;
            // A map can hold cutouts; BLEND surfaces, which only cast when asked to, are whole.
            gl::Program& variant = program({view.kind, material.alphaMode == AlphaMode::mask});
            variant.use();
            variant.set("u_clipFromObject", glm::mat4(clipFromMap * mapFromObject));
            variant.set("u_mapFromObject", glm::mat4(mapFromObject));
            drawChunk(scene, chunk, variant);
        }
    }
}

void ShadowMapPass::drawChunk(const GpuScene& scene, const SurfaceChunk& chunk,
                              gl::Program& program) {
    const Material& material = scene.materials[chunk.material];
    AttributeBinding binding(nullptr);
    constexpr std::size_t stride = sizeof(SurfaceVertex);
    binding.add(chunk.vertices, 3, GL_FLOAT, false, stride, offsetof(SurfaceVertex, position),
                false);
    if (material.alphaMode == AlphaMode::mask) {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, scene.textures.of(material.baseColor()));
        program.setSampler("u_texture", 0);
        program.set("u_alphaScale", material.baseColorFactor.a);
        program.set("u_alphaCutoff", material.alphaCutoff);
        binding.add(chunk.vertices, 2, GL_FLOAT, false, stride, offsetof(SurfaceVertex, texcoord),
                    false);
        binding.add(chunk.vertices, 4, GL_UNSIGNED_BYTE, true, stride,
                    offsetof(SurfaceVertex, color), false);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, chunk.indices.name());
    glDrawElements(GL_TRIANGLES, chunk.indexCount, GL_UNSIGNED_SHORT, nullptr);
    vertexRuns_ += static_cast<std::size_t>(chunk.indexCount);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

std::size_t ShadowMapPass::bytes() const {
    std::size_t total = 0;
    for (const auto& [kind, map] : targets_)
        total += map.bytes();
    return total;
}

} // namespace edgeshade
