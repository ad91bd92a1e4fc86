#include "src/rivals/maps/rival_map_pass.hpp"

#include "src/render/drawing/attributes.hpp"
#include "src/render/drawing/cap_alpha_test.hpp"
#include "src/render/drawing/caster_chunk.hpp"
#include "src/rivals/maps/map_filters.hpp"

#include <algorithm>
#include <cstddef>
#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

void addAll(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

/// Draws cut casters with their program, which must be in use.
void drawPart(const GpuScene& scene, const WarpedCasters::Part& part, const gl::Program& program) {
    using Vertex = WarpedCasters::Vertex;
    AttributeBinding binding(nullptr);
    const std::size_t stride = part.cutout ? sizeof(Vertex) : sizeof(glm::vec3);
    binding.add(part.vertices, 3, GL_FLOAT, false, stride, 0, false);
    if (part.cutout) {
        setAlphaLookup(program, alphaLookupOf(scene.materials[*part.cutout], scene.textures));
        binding.add(part.vertices, 2, GL_FLOAT, false, stride, offsetof(Vertex, texcoord), false);
        binding.add(part.vertices, 4, GL_UNSIGNED_BYTE, true, stride, offsetof(Vertex, color),
                    false);
    }
    glDrawArrays(GL_TRIANGLES, 0, part.count);
}

} // namespace

RivalMapPass::RivalMapPass(const ShadowMapSettings& settings, const gl::Capabilities& capabilities)
    : ShadowMapPass(settings, capabilities, texelWidthOf(settings)) {
    if (settings.kind == MapKind::warped) warper_.emplace(settings.warp, capabilities);
}

void RivalMapPass::beginFrame(const FrameStart& start) {
    const std::vector<FrameLight>& lights = start.view.lights;
    const bool anySun = std::any_of(lights.begin(), lights.end(), [](const FrameLight& of) {
        return of.drawn && of.light.position.w == 0.0;
    });
    if (!warper_ || !anySun) return;
    const StageScope stage(start.clock, FrameStage::map);
    warper_->look(start.view, start.drawNearness);
}

bool RivalMapPass::isParaboloid(const MapForm& form) const {
    return settings_.kind == MapKind::paraboloid && !form.parallel;
}

MapForm RivalMapPass::formOf(const Light& light) const {
    MapForm form = ShadowMapPass::formOf(light);
    // The shader averages four filtered texels itself, and finds them only in flat textures.
    if (isFiltered(settings_)) form.cube = false;
    if (isParaboloid(form)) form = {.faces = 2};
    return form;
}

/// Share of a face's width that remains beside the texels that the filter and the GL's averaging
/// reach.
double RivalMapPass::faceShare(const MapForm& form) const {
    if (!isFiltered(settings_) && !isParaboloid(form)) return 1.0;
    const double margin = std::min(2.0 + settings_.pcf / 2, 0.25 * settings_.size);
    return 1.0 - 2.0 * margin / settings_.size;
}

ShadowMapView RivalMapPass::viewOf(const Light& light, const MapSubject& subject,
                                   const FrameView& frame, int depthBits) {
    receivers_ = formOf(light);
    const glm::dvec3 position(light.position);
    if (!receivers_.parallel) {
        ShadowMapView view = pointMapView(position / light.position.w, subject.bounds, light.range,
                                          settings_.size, faceShare(receivers_), depthBits);
        if (!isParaboloid(receivers_)) return view;
        const bool seesScene = std::any_of(view.faces.begin(), view.faces.end(),
                                           [](const auto& face) { return face.seesScene; });
        // Each half's margin also shows the other half; setProjection() projects.
        view.faces.assign(2, {glm::dmat4(1.0), seesScene});
        return view;
    }
    if (!warper_) return ShadowMapPass::viewOf(light, subject, frame, depthBits);
    ShadowMapView view = sunMapView(position, subject, frame, settings_, false);
    const double margin = frameTexels(settings_);
    view.share = (settings_.size - 2.0 * margin) / settings_.size;
    warper_->fit(view, margin / settings_.size); // the warp adds the frame
    return view;
}

std::vector<std::string> RivalMapPass::casterDefines(const MapForm& form) const {
    std::vector<std::string> defines = ShadowMapPass::casterDefines(form);
    if (isParaboloid(form)) defines.emplace_back("MAP_PARABOLOID");
    if (isWarped(form)) defines.emplace_back("MAP_WARPED");
    if (capabilities_.has("GL_OES_standard_derivatives")) defines.emplace_back("DERIVATIVES");
    return defines;
}

std::vector<std::string> RivalMapPass::receiverDefines(const MapForm& form) const {
    std::vector<std::string> defines = ShadowMapPass::receiverDefines(form);
    addAll(defines, filterDefines(settings_.filter));
    if (isParaboloid(form)) defines.emplace_back("MAP_PARABOLOID");
    if (isWarped(form)) defines.push_back("MAP_WARPED " + std::to_string(MapWarp::cells));
    return defines;
}

void RivalMapPass::drawFace(const MapTask& task, std::size_t face) {
    if (!isWarped(task.map.form())) return ShadowMapPass::drawFace(task, face);
    for (const WarpedCasters::Part& part : warper_->cut(task.scene, task.view).parts()) {
        drawPart(task.scene, part, program(task.map.form(), part.cutout.has_value()));
        vertexRuns_ += static_cast<std::size_t>(part.count);
    }
}

/// Sets the projection of shaders_es2/shadow_map.vert and .frag.
void RivalMapPass::setProjection(const gl::Program& program, const MapTask& task, std::size_t face,
                                 const glm::dmat4& mapFromObject) const {
    if (!isParaboloid(task.map.form()))
        return ShadowMapPass::setProjection(program, task, face, mapFromObject);
    const double share = task.view.share;
    program.set("u_halfSide", face == 0 ? 1.0f : -1.0f);
    program.set("u_mapShare", static_cast<float>(share));
    program.set("u_onDisc", glm::vec2(2.0 / (settings_.size * share), -1.0 / share));
}

void RivalMapPass::finish(const MapTask& task) {
    if (!isFiltered(settings_)) return;
    if (!blur_) blur_.emplace(settings_);
    for (std::size_t face = 0; face < task.view.faces.size(); ++face)
        blur_->filter(task.map, face);
    glEnable(GL_DEPTH_TEST);
}

void RivalMapPass::set(const gl::Program& program, int unit) const {
    program.set("u_mapTexels", static_cast<float>(settings_.size));
    program.set("u_bleeding", bleedingShareOf(settings_));
    if (isWarped(receivers_)) warper_->set(program, unit);
}

std::string RivalMapPass::faceWords(const Light& light) const {
    const MapForm form = formOf(light);
    if (isParaboloid(form)) return "two paraboloids";
    if (!isWarped(form)) return ShadowMapPass::faceWords(light);
    return settings_.warp == WarpGrid::rectilinear ? "one map, warped along its columns and rows,"
                                                   : "one map, warped by a non-orthogonal grid,";
}

std::string RivalMapPass::filterWords() const {
    return filterWordsOf(settings_.filter);
}

std::size_t RivalMapPass::bytes() const {
    return ShadowMapPass::bytes() + (blur_ ? blur_->bytes() : 0) + (warper_ ? warper_->bytes() : 0);
}

std::size_t RivalMapPass::bytesOf(const Light& light) const {
    const std::size_t bytes = ShadowMapPass::bytesOf(light);
    return bytes + (bytes > 0 && isWarped(formOf(light)) ? warper_->warpBytes() : 0);
}

} // namespace edgeshade
