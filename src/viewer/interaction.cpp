#include "src/viewer/interaction.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace edgeshade::viewer {
namespace {

constexpr double turnAPicture = glm::pi<double>(); // radians that a drag over the picture's height
                                                   // orbits
constexpr double zoomANotch = 0.88;
// Limits for the pivot's distance, in sizes of the scene.
constexpr double nearestPivot = 1e-5;
constexpr double farthestPivot = 100.0;

/// The point under the pixel: on a surface, else on the plane through the pivot.
glm::dvec3 pointAt(const Camera& camera, const glm::dvec2& pixel, const Stage& stage) {
    const PictureView view = stage.viewOf(camera);
    if (stage.firstHit)
        if (const auto hit = stage.firstHit(view.rayThrough(pixel))) return *hit;
    return view.pointAt(pixel, view.depthOf(camera.to));
}

Camera zoomedTo(const Camera& camera, const glm::dvec3& target, double factor, const Stage& stage) {
    return zoomed(camera, target, factor, nearestPivot * stage.size(),
                  farthestPivot * stage.size());
}

/// The depth of a point, or of the pivot if the point is now behind the eye.
double panDepth(const PictureView& view, const glm::dvec3& held) {
    const double depth = view.depthOf(held);
    return depth > 0.0 ? depth : view.depthOf(view.camera.to);
}

/// The section's plane whose handle is at the pixel.
std::optional<std::size_t> planeAt(const glm::dvec2& pixel, const ViewState& state,
                                   const Stage& stage) {
    if (!state.section || !state.showLights) return std::nullopt;
    return sectionPlaneAt(sectionHandles(*state.section, stage.bounds), pixel,
                          stage.viewOf(state.camera), stage.pixelRatio);
}

} // namespace

Camera zoomedTowards(const Camera& camera, const glm::dvec2& pixel, double factor,
                     const Stage& stage) {
    return zoomedTo(camera, pointAt(camera, pixel, stage), factor, stage);
}

ViewState Interaction::down(const Pointer& pointer, const ViewState& state, const Stage& stage) {
    gestures_.down(pointer);
    const glm::dvec2 pixel = pointer.place();
    light_.reset();
    section_.reset();
    ViewState next = state;
    if (gestures_.count() > 1) {
        drag_ = Drag::none;
        held_ = pointAt(state.camera, pixel, stage);
        return next;
    }
    const PictureView view = stage.viewOf(state.camera);
    const LightHandles handles = stage.handles();
    const bool primary = pointer.button == PointerButton::primary;
    std::optional<std::size_t> grabbed;
    if (primary && pointer.control && !state.lights.empty())
        grabbed = state.chosenLight;
    else if (primary && !pointer.shift && state.showLights)
        grabbed = handles.lightAt(state.lights, pixel, view, grabReach * stage.pixelRatio);

    if (grabbed) {
        next.chosenLight = *grabbed;
        light_.emplace(handles, next.lights[*grabbed], view, pixel);
        drag_ = Drag::light;
    } else if (const auto plane = planeAt(pixel, state, stage);
               plane && primary && !pointer.shift) {
        section_.emplace(*plane, *state.section, stage.bounds, view, pixel);
        drag_ = Drag::section;
    } else if (primary && state.split &&
               std::abs(pixel.x - state.splitAt * stage.width) <= splitReach * stage.pixelRatio) {
        drag_ = Drag::split;
    } else if (primary && !pointer.shift) {
        drag_ = Drag::orbit;
    } else {
        drag_ = Drag::pan;
        held_ = pointAt(state.camera, pixel, stage);
    }
    return next;
}

std::optional<ViewState> Interaction::move(const Pointer& pointer, const ViewState& state,
                                           const Stage& stage) {
    const auto motion = gestures_.move(pointer);
    if (!motion) return std::nullopt;
    return moved(*motion, state, stage);
}

ViewState Interaction::moved(const Motion& motion, const ViewState& state, const Stage& stage) {
    ViewState next = state;
    const glm::dvec2 way = motion.to - motion.from;
    const PictureView view = stage.viewOf(state.camera);
    if (motion.pinch) {
        const glm::dvec3 target = view.pointAt(motion.from, panDepth(view, held_));
        next.camera = zoomedTo(state.camera, target, 1.0 / motion.spread, stage);
        const PictureView nearer = stage.viewOf(next.camera);
        next.camera = panned(nearer, way, panDepth(nearer, target));
        return next;
    }
    const double radians = turnAPicture / stage.height;
    switch (drag_) {
    case Drag::orbit:
        next.camera = orbited(state.camera, -way.x * radians, way.y * radians);
        break;
    case Drag::pan:
        next.camera = panned(view, way, panDepth(view, held_));
        break;
    case Drag::light:
        if (light_ && state.chosenLight < state.lights.size())
            next.lights[state.chosenLight] =
                light_->movedTo(motion.to, state.lights[state.chosenLight], view);
        break;
    case Drag::section:
        if (section_ && state.section)
            next.section = section_->movedTo(motion.to, *state.section, view);
        break;
    case Drag::split:
        next.splitAt = std::clamp(motion.to.x / stage.width, 0.0, 1.0);
        break;
    case Drag::none:
        break;
    }
    return next;
}

void Interaction::up(const Pointer& pointer) {
    gestures_.up(pointer);
    light_.reset();
    section_.reset();
    // The remaining finger continues as if it had come down alone.
    drag_ = gestures_.count() == 1 ? Drag::orbit : Drag::none;
}

ViewState Interaction::wheel(const glm::dvec2& pixel, double notches, const ViewState& state,
                             const Stage& stage) const {
    ViewState next = state;
    next.camera = zoomedTowards(state.camera, pixel, std::pow(zoomANotch, notches), stage);
    return next;
}

} // namespace edgeshade::viewer
