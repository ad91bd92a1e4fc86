#include "src/render/shadow_map/shadow_map_pass.hpp"

#include "preprocess/base/error.hpp"
#include "shaders_es2.hpp"
#include "src/gl/framebuffer_keeper.hpp"
#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/caster_chunk.hpp"
#include "src/render/shadow_map/pcss_view.hpp"
#include "src/shadow/lights/light_range.hpp"

#include <algorithm>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

bool hasSurfaces(const GpuScene& scene) {
    return std::any_of(scene.batches.begin(), scene.batches.end(),
                       [](const GpuBatch& batch) { return !batch.surfaces->empty(); });
}

bool isSun(const Light& light) {
    return light.position.w == 0.0;
}

} // namespace

ShadowMapPass::ShadowMapPass(const ShadowMapSettings& settings,
                             const gl::Capabilities& capabilities, int texelWidth)
    : settings_(settings), capabilities_(capabilities), texelWidth_(texelWidth) {
    requireMapSize(settings.size, texelWidth, capabilities);
}

MapForm ShadowMapPass::formOf(const Light& light) const {
    if (!isSun(light)) return {.cube = !settings_.facesApart, .faces = 6};
    return {.parallel = true,
            .faces = settings_.kind == MapKind::cascades ? settings_.cascades : 1};
}

ShadowMapView ShadowMapPass::viewOf(const Light& light, const MapSubject& subject,
                                    const FrameView& frame, int depthBits) {
    const glm::dvec3 position(light.position);
    if (isSun(light)) return sunMapView(position, subject, frame, settings_);
    return pointMapView(position / light.position.w, subject.bounds, light.range, settings_.size,
                        1.0, depthBits);
}

std::vector<std::string> ShadowMapPass::casterDefines(const MapForm& form) const {
    if (form.parallel) return {"MAP_DIRECTIONAL"};
    return {};
}

std::vector<std::string> ShadowMapPass::receiverDefines(const MapForm& form) const {
    std::vector<std::string> defines = {"PCF " + std::to_string(settings_.pcf)};
    if (!form.cube) defines.push_back("MAP_FACES " + std::to_string(form.faces));
    if (form.parallel) defines.emplace_back("MAP_DIRECTIONAL");
    if (form.parallel && settings_.kind == MapKind::cascades)
        defines.push_back("MAP_CASCADES " + std::to_string(form.faces));
    return defines;
}

ShadowMapPass::Kept& ShadowMapPass::kept(const Light& light) {
    const auto found = kept_.find(isSun(light));
    if (found != kept_.end()) return found->second;
    ShadowMapTarget target(formOf(light), settings_.size, texelWidth_, capabilities_);
    std::vector<std::string> defines = receiverDefines(target.form());
    return kept_.emplace(isSun(light), Kept{std::move(target), std::move(defines)}).first->second;
}

const gl::Program& ShadowMapPass::program(const MapForm& form, bool alphaTest) {
    const gl::Program& program = programs_.get({form.parallel, alphaTest}, [&] {
        std::vector<std::string> defines = casterDefines(form);
        if (alphaTest) defines.emplace_back("ALPHA_TEST");
        return gl::Program(shaders::shadow_map_vert, shaders::shadow_map_frag, defines,
                           casterAttributes);
    });
    program.use();
    return program;
}

ShadowMapLookup ShadowMapPass::draw(const GpuScene& scene, const FrameView& frame,
                                    const Light& light) {
    if (frame.bounds.empty() && hasSurfaces(scene))
        throw Error(ExitStatus::unavailable,
                    "A shadow map needs the scene's bounds, and this view has none.");
    const gl::FramebufferKeeper keeper;
    Kept& of = kept(light);
    const ShadowMapTarget& map = of.target;
    const ShadowMapView view =
        viewOf(light, subjectOf(scene, frame.bounds), frame, map.depthBits());
    Drawn wanted = drawnOf(scene, view, light);
    vertexRuns_ = 0;
    if (of.drawn != wanted) {
        drawFaces({scene, light, view, map});
        of.drawn = std::move(wanted);
    }
    ShadowMapLookup lookup{.textures = map.textures(),
                           .faces = map.flatCount(),
                           .defines = &of.defines,
                           .mapFromWorld = view.mapFromWorld,
                           .step = static_cast<float>(view.step),
                           .texel = static_cast<float>(view.texel),
                           .biasTexels = settings_.biasTexels};
    lookup.soft = settings_.soft != SoftShadows::none && light.extent;
    if (settings_.soft == SoftShadows::pcss && light.extent) lookup.pcss = pcssLight(light, view);
    lookup.share = static_cast<float>(view.share);
    lookup.mapScale = glm::vec3(view.scale());
    lookup.further = further();
    if (view.cascades.empty()) return lookup;
    lookup.cascadeCount = static_cast<std::size_t>(lookup.faces);
    for (std::size_t i = 0; i < lookup.cascadeCount; ++i) { // unused ones repeat the last
        const std::size_t drawn = std::min(i, view.cascades.size() - 1);
        lookup.cascades[i] = glm::vec4(view.cascades[drawn]);
        lookup.textures[i] = lookup.textures[drawn];
    }
    lookup.cascadeMargin = static_cast<float>(view.cascadeMargin);
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

void ShadowMapPass::drawFaces(const MapTask& task) {
    glViewport(0, 0, settings_.size, settings_.size);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER); // the bytes are not colours
    glClearColor(1.0f, 1.0f, 1.0f, 1.0f);
    for (std::size_t face = 0; face < task.view.faces.size(); ++face) {
        task.map.bindFace(face);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (task.view.faces[face].seesScene) drawFace(task, face);
    }
    finish(task);
    glEnable(GL_DITHER);
}

void ShadowMapPass::drawFace(const MapTask& task, std::size_t face) {
    const GpuScene& scene = task.scene;
    for (const GpuBatch& batch : scene.batches) {
        if (batch.hidden) continue;
        const glm::dvec3 source(glm::inverse(batch.worldFromBatch) * task.light.position);
        const double range = rangeInObject(task.light, batch.worldFromBatch);
        const glm::dmat4 mapFromObject = task.view.mapFromWorld * batch.worldFromBatch;
        for (const SurfaceChunk& chunk : *batch.surfaces) {
            const Material& material = scene.materials[chunk.material];
            if (!scene.castsInMaps(material) || isBeyond(chunk.bounds, source, range)) continue;
            // A map can have cutouts of MASK casters; BLEND surfaces, which cast only on request,
            // are whole.
            const gl::Program& used =
                program(task.map.form(), material.alphaMode == AlphaMode::mask);
            setProjection(used, task, face, mapFromObject);
            used.set("u_mapFromObject", glm::mat4(mapFromObject));
            vertexRuns_ += drawCasterChunk(scene, chunk, used);
        }
    }
}

void ShadowMapPass::setProjection(const gl::Program& program, const MapTask& task, std::size_t face,
                                  const glm::dmat4& mapFromObject) const {
    program.set("u_clipFromObject", glm::mat4(task.view.faces[face].clipFromMap * mapFromObject));
}

std::string ShadowMapPass::faceWords(const Light& light) const {
    if (!isSun(light)) return "a cube's six faces";
    return settings_.kind == MapKind::cascades
               ? "up to " + std::to_string(settings_.cascades) + " cascades"
               : "one map";
}

std::string ShadowMapPass::words(const Light& light) const {
    const std::string size = std::to_string(settings_.size);
    const std::string words = faceWords(light) + " of " + size + " x " + size + " texels, ";
    if (settings_.soft == SoftShadows::pcss && light.extent)
        return words + "percentage-closer soft shadows";
    return words + filterWords() + ", " + std::to_string(settings_.pcf) + " wide";
}

std::size_t ShadowMapPass::bytes() const {
    std::size_t total = 0;
    for (const auto& [parallel, of] : kept_)
        total += of.target.bytes();
    return total;
}

std::size_t ShadowMapPass::bytesOf(const Light& light) const {
    const auto found = kept_.find(isSun(light));
    return found != kept_.end() ? found->second.target.bytes() : 0;
}

} // namespace edgeshade
