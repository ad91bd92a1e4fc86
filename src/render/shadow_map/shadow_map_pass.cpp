#include "src/render/shadow_map/shadow_map_pass.hpp"

#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/caster_chunk.hpp"
#include "src/render/shadow_map/pcss_view.hpp"
#include "src/scene/build_parts.hpp"
#include "src/shadow/lights/light_range.hpp"

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
    const bool plain = settings.kind == MapKind::cube && settings.filter == MapFilter::compare;
    if (!allMapKinds && !plain)
        throw Error(ExitStatus::unavailable,
                    "This build's shadow maps are cubes and single ones, compared, alone.");
    requireMapSize(settings, capabilities);
}

const ShadowMapTarget& ShadowMapPass::target(ShadowMapKind kind) {
    auto found = targets_.find(kind);
    if (found == targets_.end())
        found = targets_.emplace(kind, ShadowMapTarget(kind, settings_, capabilities_)).first;
    return found->second;
}

gl::Program& ShadowMapPass::program(const Variant& variant) {
    auto found = programs_.find(variant);
    if (found == programs_.end()) {
        std::vector<std::string> defines;
        if (isParallel(variant.kind)) defines.push_back("MAP_DIRECTIONAL");
        if (variant.kind == ShadowMapKind::paraboloid) defines.push_back("MAP_PARABOLOID");
        if (variant.kind == ShadowMapKind::warped) defines.push_back("MAP_WARPED");
        if (capabilities_.has("GL_OES_standard_derivatives")) defines.push_back("DERIVATIVES");
        if (variant.alphaTest) defines.push_back("ALPHA_TEST");
        found =
            programs_
                .emplace(variant, gl::Program(shaders::shadow_map_vert, shaders::shadow_map_frag,
                                              defines, casterAttributes))
                .first;
    }
    return found->second;
}

ShadowMapLookup ShadowMapPass::draw(const GpuScene& scene, const FrameView& frame,
                                    const Light& light, std::span<const glm::dvec3> visible) {
    if (frame.bounds.empty() && hasSurfaces(scene))
        throw Error(ExitStatus::unavailable,
                    "A shadow map needs the scene's bounds, and this view has none.");
    const gl::FramebufferKeeper keeper;
    const ShadowMapKind kind = mapKindOf(light, settings_);
    const ShadowMapTarget& map = target(kind);
    const ShadowMapView view = shadowMapView(light, subjectOf(scene, frame.bounds), frame,
                                             settings_, map.depthBits(), visible);
    Drawn wanted = drawnOf(scene, view, light);
    vertexRuns_ = 0;
    if (drawn_[kind] != wanted) {
        drawFaces(scene, view, map, light);
        drawn_[kind] = std::move(wanted);
    }
    ShadowMapLookup lookup{map.kind(),
                           map.textures(),
                           map.flatCount(),
                           view.mapFromWorld,
                           static_cast<float>(view.step),
                           static_cast<float>(view.texel),
                           settings_.biasTexels};
    lookup.soft = settings_.soft != SoftShadows::none && light.extent;
    if (settings_.soft == SoftShadows::pcss && light.extent) lookup.pcss = pcssLight(light, view);
    lookup.filter = settings_.filter;
    lookup.texels = static_cast<float>(settings_.size);
    lookup.share = static_cast<float>(view.share);
    lookup.mapScale = glm::vec3(view.scale());
    for (std::size_t i = 0; i < lookup.cascades.size() && !view.cascades.empty(); ++i) {
        const std::size_t drawn = std::min(i, view.cascades.size() - 1);
        lookup.cascades[i] = glm::vec4(view.cascades[drawn]);
        lookup.textures[i] = lookup.textures[drawn];
    }
    lookup.cascadeMargin = static_cast<float>(view.cascadeMargin);
    lookup.bleeding = settings_.bleedingShare();
    if constexpr (allMapKinds) {
        if (view.warp) {
            lookup.warp = warp_->texture();
            lookup.warpInner = glm::vec4(view.warp->inner());
            lookup.warpOuter = glm::vec4(view.warp->outer());
        }
    }
    return lookup;
}

MapSubject ShadowMapPass::subjectOf(const GpuScene& scene, const Box& bounds) {
    MapSubject subject;
    subject.bounds = bounds.empty() ? Box{glm::dvec3(0.0), glm::dvec3(0.0)} : bounds;
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden) continue;
        for (const SurfaceChunk& chunk : *batch.surfaces) {
            if (!scene.castsInMaps(scene.materials[chunk.material])) continue;
            subject.casters.push_back(chunk.bounds);
            subject.worldFromCasters.push_back(batch.worldFromBatch);
        }
    }
    return subject;
}

ShadowMapPass::Drawn ShadowMapPass::drawnOf(const GpuScene& scene, const ShadowMapView& view,
                                            const Light& light) {
    Drawn drawn{scene.identity, view, {}, scene.cutoutsCast, light.range};
    for (const GpuBatch& batch : scene.batches)
        drawn.batches.emplace_back(batch.worldFromBatch, batch.hidden);
    return drawn;
}

void ShadowMapPass::drawFaces(const GpuScene& scene, const ShadowMapView& view,
                              const ShadowMapTarget& map, const Light& light) {
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
        if (view.warp)
            drawWarped(scene, view);
        else if (view.faces[face].seesScene)
            drawCasters(scene, view, face, light);
    }
    if constexpr (allMapKinds)
        if (settings_.isFiltered()) {
            if (!blur_) blur_.emplace(settings_);
            for (std::size_t face = 0; face < view.faces.size(); ++face)
                blur_->filter(map, face);
            glEnable(GL_DEPTH_TEST);
        }
    glEnable(GL_DITHER);
}

void ShadowMapPass::drawCasters(const GpuScene& scene, const ShadowMapView& view, std::size_t face,
                                const Light& light) {
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden) continue;
        const glm::dvec3 source(glm::inverse(batch.worldFromBatch) * light.position);
        const double range = rangeInObject(light, batch.worldFromBatch);
        const glm::dmat4 mapFromObject = view.mapFromWorld * batch.worldFromBatch;
        for (const SurfaceChunk& chunk : *batch.surfaces) {
            const Material& material = scene.materials[chunk.material];
            if (!scene.castsInMaps(material) || isBeyond(chunk.bounds, source, range)) continue;
            // A map can hold cutouts; BLEND surfaces, which only cast when asked to, are whole.
            gl::Program& variant = program({view.kind, material.alphaMode == AlphaMode::mask});
            variant.use();
            if (view.kind == ShadowMapKind::paraboloid)
                setHalf(variant, view, face);
            else
                variant.set("u_clipFromObject",
                            glm::mat4(view.faces[face].clipFromMap * mapFromObject));
            variant.set("u_mapFromObject", glm::mat4(mapFromObject));
            vertexRuns_ += drawCasterChunk(scene, chunk, variant);
        }
    }
}

void ShadowMapPass::drawWarped(const GpuScene& scene, const ShadowMapView& view) {
    if constexpr (allMapKinds) {
        if (!warp_) warp_.emplace();
        warp_->fill(*view.warp);
        warpedCasters_ = WarpedCasters(scene, view);
        for (const WarpedCasters::Part& part : warpedCasters_.parts()) {
            gl::Program& variant = program({view.kind, part.cutout.has_value()});
            variant.use();
            AttributeBinding binding(nullptr);
            using Vertex = WarpedCasters::Vertex;
            const std::size_t stride = part.cutout ? sizeof(Vertex) : sizeof(glm::vec3);
            binding.add(part.vertices, 3, GL_FLOAT, false, stride, 0, false);
            if (part.cutout) {
                setCasterCutout(scene, scene.materials[*part.cutout], variant);
                binding.add(part.vertices, 2, GL_FLOAT, false, stride, offsetof(Vertex, texcoord),
                            false);
                binding.add(part.vertices, 4, GL_UNSIGNED_BYTE, true, stride,
                            offsetof(Vertex, color), false);
            }
            glDrawArrays(GL_TRIANGLES, 0, part.count);
            vertexRuns_ += static_cast<std::size_t>(part.count);
        }
    }
}

/// See shaders_es2/shadow_map.vert and .frag.
void ShadowMapPass::setHalf(const gl::Program& program, const ShadowMapView& view,
                            std::size_t face) const {
    program.set("u_halfSide", face == 0 ? 1.0f : -1.0f);
    program.set("u_mapShare", static_cast<float>(view.share));
    program.set("u_onDisc", glm::vec2(2.0 / (settings_.size * view.share), -1.0 / view.share));
}

std::size_t ShadowMapPass::bytes() const {
    std::size_t total = 0;
    for (const auto& [kind, map] : targets_)
        total += map.bytes();
    if constexpr (allMapKinds) total += (blur_ ? blur_->bytes() : 0) + warpBytes();
    return total;
}

std::size_t ShadowMapPass::bytesOf(const Light& light) const {
    const ShadowMapKind kind = mapKindOf(light, settings_);
    const auto found = targets_.find(kind);
    if (found == targets_.end()) return 0;
    return found->second.bytes() + (kind == ShadowMapKind::warped ? warpBytes() : 0);
}

std::size_t ShadowMapPass::warpBytes() const {
    if constexpr (allMapKinds)
        return warp_ ? WarpTable::bytes() + warpedCasters_.bytes() : 0;
    else
        return 0;
}

} // namespace edgeshade
