#include "src/viewer/commands.hpp"

#include "src/viewer/interaction.hpp"
#include "src/viewer/section_tool.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

constexpr double turn = glm::radians(5.0);
constexpr double panShare = 0.05; // share of the picture's height
constexpr double zoomStep = 0.85;
constexpr double lightTurn = glm::radians(3.0);
constexpr double lightShare = 0.02; // share of the picture's height
constexpr double lightStep = 0.94;  // share of the light's distance from the eye
constexpr double splitStep = 0.02;
constexpr double speedStep = 1.25;
constexpr std::chrono::minutes timeStep(10); // step of the sun's time
constexpr std::size_t lightsInARow = 8;      // added lights take this many places in turn

Camera pannedBy(const ViewState& state, const Stage& stage, double x, double y) {
    const PictureView view = stage.viewOf(state.camera);
    return panned(view, glm::dvec2(x, y) * (panShare * stage.height),
                  view.depthOf(state.camera.to));
}

Camera zoomedBy(const ViewState& state, const Stage& stage, double factor) {
    return zoomedTowards(state.camera, 0.5 * glm::dvec2(stage.width, stage.height), factor, stage);
}

/// Moves a point light in the plane parallel to the picture; turns a sun around the world's
/// vertical axis or towards its poles.
Light lightMoved(const Light& light, const ViewState& state, const Stage& stage, double x,
                 double y) {
    if (light.position.w == 0.0) {
        Camera around;
        around.from = glm::normalize(glm::dvec3(light.position));
        around.to = glm::dvec3(0.0);
        return light.at(glm::dvec4(orbited(around, x * lightTurn, -y * lightTurn).from, 0.0));
    }
    const PictureView view = stage.viewOf(state.camera);
    const glm::dvec3 place(light.position);
    const double depth =
        view.depthOf(place) > 0.0 ? view.depthOf(place) : view.depthOf(state.camera.to);
    // The camera follows the light by a pan the other way.
    const Camera followed = panned(view, -glm::dvec2(x, y) * (lightShare * stage.height), depth);
    return light.at(glm::dvec4(place + followed.from - state.camera.from, 1.0));
}

Light lightAlongView(const Light& light, const ViewState& state, double factor) {
    if (light.position.w == 0.0) return light;
    const glm::dvec3 eye = state.camera.from;
    return light.at(glm::dvec4(eye + (glm::dvec3(light.position) - eye) * factor, 1.0));
}

void addLight(ViewState& state, const Stage& stage) {
    if (state.lights.size() >= mostLights) return;
    const double side = 0.12 * static_cast<double>(state.lights.size() % lightsInARow);
    const glm::dvec3 place =
        stage.bounds.center() + stage.size() * glm::dvec3(side, 0.3, 0.1 - 0.5 * side);
    state.lights.push_back({glm::dvec4(place, 1.0)});
    state.chosenLight = state.lights.size() - 1;
}

void removeLight(ViewState& state) {
    if (state.lights.size() < 2) return;
    state.lights.erase(state.lights.begin() + static_cast<std::ptrdiff_t>(state.chosenLight));
    state.chosenLight = std::min(state.chosenLight, state.lights.size() - 1);
}

ShadowMethod next(ShadowMethod method) {
    switch (method) {
    case ShadowMethod::automatic:
        return ShadowMethod::volumes;
    case ShadowMethod::volumes:
        return ShadowMethod::primitiveMap;
    case ShadowMethod::primitiveMap:
        return ShadowMethod::map;
    case ShadowMethod::map:
    case ShadowMethod::planar:
        return ShadowMethod::none;
    default:
        return ShadowMethod::automatic;
    }
}

/// Commands about lights. Returns false for any other command.
bool runOnLights(Command command, ViewState& state, const Stage& stage) {
    if (state.lights.empty()) return false;
    Light& light = state.lights[state.chosenLight];
    switch (command) {
    case Command::lightLeft:
        light = lightMoved(light, state, stage, -1.0, 0.0);
        return true;
    case Command::lightRight:
        light = lightMoved(light, state, stage, 1.0, 0.0);
        return true;
    case Command::lightUp:
        light = lightMoved(light, state, stage, 0.0, -1.0);
        return true;
    case Command::lightDown:
        light = lightMoved(light, state, stage, 0.0, 1.0);
        return true;
    case Command::lightNearer:
        light = lightAlongView(light, state, lightStep);
        return true;
    case Command::lightFarther:
        light = lightAlongView(light, state, 1.0 / lightStep);
        return true;
    case Command::nextLight:
        state.chosenLight = (state.chosenLight + 1) % state.lights.size();
        return true;
    case Command::addLight:
        addLight(state, stage);
        return true;
    case Command::removeLight:
        removeLight(state);
        return true;
    case Command::toggleSun:
        light = stage.handles().turnedOver(light);
        return true;
    default:
        return false;
    }
}

/// Commands about a sun by place and time. Returns false for any other command.
bool runOnSun(Command command, ViewState& state) {
    const auto move = [&](std::chrono::seconds by) {
        if (state.sun) state.sun = movedBy(*state.sun, by);
        return true;
    };
    switch (command) {
    case Command::toggleDay:
        state.dayPlays = state.sun && !state.dayPlays;
        return true;
    case Command::toggleHours:
        state.sunHours = state.sun && !state.sunHours;
        return true;
    case Command::earlier:
        return move(-timeStep);
    case Command::later:
        return move(timeStep);
    case Command::dayEarlier:
        return move(-std::chrono::hours(24));
    case Command::dayLater:
        return move(std::chrono::hours(24));
    default:
        return false;
    }
}

/// Commands about the section. Returns false for any other command.
bool runOnSection(Command command, ViewState& state, const Stage& stage) {
    std::optional<Section>& section = state.section;
    const auto along = [&](glm::length_t axis) {
        section = sectionAlong(axis, section, stage.bounds, state.camera.from);
        return true;
    };
    switch (command) {
    case Command::sectionX:
        return along(0);
    case Command::sectionY:
        return along(1);
    case Command::sectionZ:
        return along(2);
    case Command::sectionFree:
        section = sectionFacing(section, stage.bounds, stage.viewOf(state.camera).forward());
        return true;
    case Command::sectionBox:
        section = sectionBoxOf(section, stage.bounds);
        return true;
    case Command::sectionFlip:
        section = sectionFlipped(section);
        return true;
    case Command::sectionShadows:
        section = sectionWithOtherShadows(section);
        return true;
    case Command::sectionOff:
        section.reset();
        return true;
    default:
        return false;
    }
}

/// Commands about the camera. Returns false for any other command.
bool runOnCamera(Command command, ViewState& state, const Stage& stage) {
    Camera& camera = state.camera;
    switch (command) {
    case Command::orbitLeft:
        camera = orbited(camera, -turn, 0.0);
        return true;
    case Command::orbitRight:
        camera = orbited(camera, turn, 0.0);
        return true;
    case Command::orbitUp:
        camera = orbited(camera, 0.0, turn);
        return true;
    case Command::orbitDown:
        camera = orbited(camera, 0.0, -turn);
        return true;
    case Command::panLeft:
        camera = pannedBy(state, stage, 1.0, 0.0);
        return true;
    case Command::panRight:
        camera = pannedBy(state, stage, -1.0, 0.0);
        return true;
    case Command::panUp:
        camera = pannedBy(state, stage, 0.0, 1.0);
        return true;
    case Command::panDown:
        camera = pannedBy(state, stage, 0.0, -1.0);
        return true;
    case Command::zoomIn:
        camera = zoomedBy(state, stage, zoomStep);
        return true;
    case Command::zoomOut:
        camera = zoomedBy(state, stage, 1.0 / zoomStep);
        return true;
    case Command::fit:
        camera = stage.framed(camera.fovDegrees, camera.from - camera.to);
        return true;
    default:
        return false;
    }
}

} // namespace

ViewState framed(const ViewState& state, const Stage& stage) {
    ViewState result = state;
    result.camera = stage.framed(Camera().fovDegrees, framingDirection());
    result.lights = stage.lights;
    if (result.lights.empty()) result.lights = {defaultLight()};
    result.chosenLight = 0;
    result.sun.reset();
    result.dayPlays = result.sunHours = false;
    result.time = 0.0;
    return result;
}

ViewState after(Command command, const ViewState& before, const Stage& stage) {
    ViewState state = before;
    if (runOnLights(command, state, stage) || runOnCamera(command, state, stage) ||
        runOnSun(command, state) || runOnSection(command, state, stage))
        return state;
    ShadowMethod& shadows = state.split ? state.right.shadows : state.left.shadows;
    switch (command) {
    case Command::reset:
        return framed(state, stage);
    case Command::nextShadows:
        shadows = next(shadows);
        break;
    case Command::toggleSplit:
        state.split = !state.split;
        break;
    case Command::splitLeft:
        state.splitAt = std::max(0.0, state.splitAt - splitStep);
        break;
    case Command::splitRight:
        state.splitAt = std::min(1.0, state.splitAt + splitStep);
        break;
    case Command::toggleDebug:
        state.debug = state.debug == DebugView::none ? DebugView::volumes : DebugView::none;
        break;
    case Command::toggleGround:
        state.ground = state.ground ? GroundChoice() : GroundChoice(Ground{});
        break;
    case Command::toggleLights:
        state.showLights = !state.showLights;
        break;
    case Command::nextAnimation:
        if (stage.animations > 1) state.animation = (state.animation + 1) % stage.animations;
        break;
    case Command::togglePlaying:
        state.playing = !state.playing;
        break;
    case Command::slower:
        state.speed = std::max(slowest, state.speed / speedStep);
        break;
    case Command::faster:
        state.speed = std::min(fastest, state.speed * speedStep);
        break;
    default:
        break;
    }
    return state;
}

} // namespace edgeshade::viewer
