#include "src/viewer/viewer.hpp"

#include "src/render/frame/light_methods.hpp"
#include "src/viewer/commands.hpp"
#include "src/viewer/pick.hpp"
#include "src/viewer/viewer_parts.hpp"

#include <algorithm>
#include <cmath>
#include <GLES2/gl2.h>

namespace edgeshade::viewer {

Viewer::Viewer(const gl::Capabilities& capabilities, const ViewerSettings& settings)
    : parts_(std::make_unique<ViewerParts>()) {
    parts_->settings = settings;
    parts_->state.background = settings.render.background;
    parts_->stage.firstHit = [parts = parts_.get()](const Ray& ray) {
        return parts->shown ? firstHit(parts->shown->loaded.scene, ray) : std::nullopt;
    };
    parts_->gpu = parts_->makeGpu(capabilities);
}

Viewer::~Viewer() = default;

void Viewer::show(LoadedScene scene) {
    parts_->show(std::move(scene));
}

bool Viewer::hasScene() const {
    return parts_->shown.has_value();
}

void Viewer::resize(int width, int height, double pixelRatio) {
    parts_->stage.width = std::max(1, width);
    parts_->stage.height = std::max(1, height);
    parts_->stage.pixelRatio = pixelRatio > 0.0 ? pixelRatio : 1.0;
    parts_->unchecked = true;
    invalidate();
}

const ViewState& Viewer::state() const {
    return parts_->state;
}

void Viewer::change(const nlohmann::ordered_json& changes) {
    parts_->adopt(changed(parts_->state, changes));
}

void Viewer::pointerDown(const Pointer& pointer) {
    parts_->adopt(parts_->interaction.down(pointer, parts_->state, parts_->stage));
}

void Viewer::pointerMove(const Pointer& pointer) {
    if (const auto next = parts_->interaction.move(pointer, parts_->state, parts_->stage))
        parts_->adopt(*next);
}

void Viewer::pointerUp(const Pointer& pointer) {
    parts_->interaction.up(pointer);
}

void Viewer::wheel(double x, double y, double notches) {
    parts_->adopt(parts_->interaction.wheel({x, y}, notches, parts_->state, parts_->stage));
}

void Viewer::run(Command command) {
    parts_->adopt(after(command, parts_->state, parts_->stage));
}

std::vector<FileCamera> Viewer::cameras() const {
    return parts_->shown ? fileCameras(parts_->shown->loaded.scene) : std::vector<FileCamera>();
}

std::vector<std::string> Viewer::animations() const {
    std::vector<std::string> names;
    if (!parts_->shown) return names;
    for (const AnimationTitle& title : parts_->shown->animations())
        names.push_back(title.name);
    return names;
}

double Viewer::animationSeconds() const {
    return parts_->shown && parts_->shown->animation() ? parts_->shown->animation()->duration : 0.0;
}

LightPoints Viewer::lightPoints() const {
    if (!parts_->gpu) return {};
    const Convergence& convergence = parts_->gpu->convergence;
    return {convergence.shown(), convergence.of()};
}

LightPoints Viewer::smoothing() const {
    if (!parts_->gpu) return {};
    return {parts_->gpu->smoothing.shown(), parts_->gpu->smoothing.of()};
}

std::optional<SunHours> Viewer::sunHours() const {
    const ViewerParts& parts = *parts_;
    if (!parts.state.sunHours || !parts.gpu || !parts.gpu->hours) return std::nullopt;
    return parts.gpu->hours->progress();
}

bool Viewer::showsSunHours() const {
    return parts_->showsHours && parts_->gpu && parts_->gpu->hours;
}

std::optional<std::uint32_t> Viewer::sunHoursAt(double x, double y) const {
    const ViewerParts& parts = *parts_;
    if (!showsSunHours()) return std::nullopt;
    return parts.gpu->hours->at(glm::ivec2(std::floor(x), std::floor(y)));
}

double Viewer::sceneSize() const {
    return parts_->shown ? parts_->stage.bounds.diagonal() : 0.0;
}

nlohmann::ordered_json Viewer::sun() const {
    const auto& sun = parts_->state.sun;
    if (!sun) return nullptr;
    return toJson(sun->position(), parts_->sunDays.of(*sun));
}

bool Viewer::frame(double now) {
    ViewerParts& parts = *parts_;
    if (parts.clock.advance(now, animationSeconds(), parts.state)) parts.applyPose();
    if (const auto sun = parts.dayClock.advance(now, parts.state)) {
        ViewState next = parts.state;
        next.sun = sun;
        parts.adopt(next);
    }
    parts.advanceMaps(now);
    parts.converge(now);
    parts.countHours(now);
    parts.smooth(now);
    if (!parts.dirty || !parts.gpu) return false;
    parts.dirty = false;
    if (parts.shown) {
        parts.draw();
    } else {
        const glm::vec3& color = parts.state.background;
        glClearColor(color.r, color.g, color.b, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    return true;
}

void Viewer::invalidate() {
    parts_->dirty = true;
}

bool Viewer::wantsFrame() const {
    const bool plays = parts_->state.playing && animationSeconds() > 0.0;
    return parts_->gpu &&
           (parts_->dirty || plays || parts_->state.dayPlays || parts_->mapsPending ||
            parts_->gpu->convergence.wantsMore() || parts_->gpu->smoothing.wantsMore() ||
            (parts_->gpu->hours && parts_->gpu->hours->wantsMore()));
}

FrameStats Viewer::stats() const {
    ViewerParts& parts = *parts_;
    parts.meter.request();
    FrameStats stats;
    if (!parts.shown) return stats;
    parts.meter.describe(stats);
    stats.triangles = parts.shown->loaded.scene.triangleCount();
    const EdgeCounts& counts = parts.shown->edgesFor(parts.state.lights[parts.state.chosenLight]);
    stats.edges = counts.edges;
    stats.records = counts.records;
    stats.silhouettes = counts.silhouettes;
    if (!parts.gpu) return stats;
    stats.shadowBytes = parts.gpu->shadowBytes();
    stats.mapBytes = parts.gpu->renderers.mapBytes();
    if (parts.gpu && parts.gpu->scene) {
        stats.primitiveMapBytes = parts.gpu->scene->primitiveMaps.bytes();
        FrameView view;
        for (const Light& light : parts.state.lights)
            view.lights.push_back({light, {}});
        const Renderer& left = parts.gpu->renderers.of(parts.state.left, parts.state);
        stats.lights = lightMethods(*parts.gpu->scene, view, left);
    }
    return stats;
}

void Viewer::forgetGpu() {
    parts_->gpu.reset();
}

void Viewer::restoreGpu(const gl::Capabilities& capabilities) {
    parts_->gpu.reset();
    parts_->gpu = parts_->makeGpu(capabilities);
    parts_->unchecked = true;
    parts_->applyPose();
    invalidate();
}

} // namespace edgeshade::viewer
