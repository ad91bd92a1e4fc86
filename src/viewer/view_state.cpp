#include "src/viewer/view_state.hpp"

#include "src/render/accumulation/subpixels.hpp"
#include "src/render/volumes/setting_words.hpp"
#include "src/viewer/light_state.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr int smallestMap = 16;
constexpr int largestMap = 16384;

constexpr Words<MapFilter, 5> filterWords = {{{"pcf", MapFilter::compare},
                                              {"poisson", MapFilter::poisson},
                                              {"vsm", MapFilter::variance},
                                              {"esm", MapFilter::exponential},
                                              {"msm", MapFilter::moments}}};
constexpr Words<bool, 2> cullWords = {{{"auto", true}, {"off", false}}};
constexpr Words<DebugView, 2> debugWords = {
    {{"none", DebugView::none}, {"volumes", DebugView::volumes}}};

template <class Value, std::size_t N>
const char* wordOf(const Words<Value, N>& words, Value value) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    return "";
}

double fovFrom(const Field& field) {
    const double fov = field.number(0.0, 180.0);
    if (fov == 0.0 || fov == 180.0) field.fail("above 0 and below 180");
    return fov;
}

Camera cameraFrom(const Field& field, Camera camera) {
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "from")
            camera.from = value.place<3>();
        else if (key == "to")
            camera.to = value.place<3>();
        else if (key == "fov")
            camera.fovDegrees = fovFrom(value);
        else
            return false;
        return true;
    });
    if (camera.from == camera.to) field.fail("a camera whose 'from' and 'to' differ");
    return camera;
}

GroundChoice groundFrom(const Field& field) {
    const auto ground = groundFromText(field.word());
    if (!ground) field.fail("off, catcher or a colour #rrggbb");
    return *ground;
}

std::vector<Light> lightsFrom(const Field& field) {
    if (field.arraySize() < 1 || field.arraySize() > mostLights)
        field.fail("an array of 1 to " + std::to_string(mostLights) + " lights");
    std::vector<Light> lights;
    field.forEachItem([&](const Field& item) { lights.push_back(lightFrom(item)); });
    return lights;
}

int maskScaleFrom(const Field& field) {
    const int scale = field.integer(1, 4);
    if (scale == 3) field.fail("1, 2 or 4");
    return scale;
}

int filterWidthFrom(const Field& field) {
    const int width = field.integer(1, 7);
    if (width % 2 == 0) field.fail("1, 3, 5 or 7");
    return width;
}

/// Reads minutes, which must divide a day.
int stepFrom(const Field& field) {
    constexpr int day = 24 * 60;
    const int step = field.integer(1, day);
    if (day % step != 0) field.fail("minutes that divide a day");
    return step;
}

SideSettings sideFrom(const Field& field, SideSettings side) {
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "shadows")
            side.shadows = value.oneOf(words::shadows);
        else if (key == "map_size")
            side.mapSize = value.integer(smallestMap, largestMap);
        else if (key == "multiplicity")
            side.multiplicity = value.oneOf(words::multiplicity);
        else if (key == "mask_scale")
            side.maskScale = maskScaleFrom(value);
        else if (key == "map_kind")
            side.mapKind = value.oneOf(words::mapKind);
        else if (key == "cascades")
            side.cascades = value.integer(1, mostCascades);
        else if (key == "filter")
            side.filter = value.oneOf(filterWords);
        else if (key == "pcf")
            side.pcf = filterWidthFrom(value);
        else if (key == "warp")
            side.warp = value.oneOf(words::warp);
        else
            return false;
        return true;
    });
    return side;
}

Json toJson(const SideSettings& side) {
    return {{"shadows", wordOf(words::shadows, side.shadows)},
            {"map_size", side.mapSize},
            {"multiplicity", wordOf(words::multiplicity, side.multiplicity)},
            {"mask_scale", side.maskScale},
            {"map_kind", wordOf(words::mapKind, side.mapKind)},
            {"cascades", side.cascades},
            {"filter", wordOf(filterWords, side.filter)},
            {"pcf", side.pcf},
            {"warp", wordOf(words::warp, side.warp)}};
}

/// The number as a person types it, for example 0.35, whose nearest float is 0.34999999.
double shortDecimal(float value) {
    return std::round(static_cast<double>(value) * 1e6) / 1e6;
}

Json toJson(const glm::vec3& color) {
    return {shortDecimal(color.r), shortDecimal(color.g), shortDecimal(color.b)};
}

} // namespace

Json toJson(const Camera& camera) {
    return {{"from", toJson(camera.from)}, {"to", toJson(camera.to)}, {"fov", camera.fovDegrees}};
}

Json toJson(const ViewState& state) {
    Json lights = Json::array();
    for (const Light& light : state.lights)
        lights.push_back(toJson(light));
    return {{"camera", toJson(state.camera)},
            {"lights", lights},
            {"chosen_light", state.chosenLight},
            {"light_samples", state.lightSamples},
            {"smooth", state.smooth},
            {"sun", toJson(state.sun)},
            {"day_playing", state.dayPlays},
            {"sun_hours", state.sunHours},
            {"sun_hours_step", state.sunHoursStep},
            {"shading", wordOf(words::shading, state.shading)},
            {"ambient", shortDecimal(state.ambient)},
            {"exposure", shortDecimal(state.exposure)},
            {"background", toJson(state.background)},
            {"ground", textOf(state.ground)},
            {"cast_cutouts", state.castCutouts},
            {"cull", wordOf(cullWords, state.culls)},
            {"left", toJson(state.left)},
            {"right", toJson(state.right)},
            {"split", state.split},
            {"split_at", state.splitAt},
            {"debug", wordOf(debugWords, state.debug)},
            {"show_lights", state.showLights},
            {"animation", state.animation},
            {"playing", state.playing},
            {"speed", state.speed},
            {"time", state.time}};
}

ViewState changed(const ViewState& base, const Json& changes) {
    ViewState state = base;
    const Field root(Field::rootName, changes);
    // The lights are read first: they limit the index of the chosen one.
    if (const auto lights = changes.is_object() ? changes.find("lights") : changes.end();
        lights != changes.end()) {
        state.lights = lightsFrom(Field("lights", *lights));
        state.chosenLight = std::min(state.chosenLight, state.lights.size() - 1);
    }
    root.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "camera")
            state.camera = cameraFrom(value, state.camera);
        else if (key == "chosen_light")
            state.chosenLight = static_cast<std::size_t>(
                value.integer(0, std::max(0, static_cast<int>(state.lights.size()) - 1)));
        else if (key == "light_samples")
            state.lightSamples =
                static_cast<std::size_t>(value.integer(1, static_cast<int>(mostLightPoints)));
        else if (key == "smooth")
            state.smooth =
                static_cast<std::size_t>(value.integer(1, static_cast<int>(mostSubpixels)));
        else if (key == "sun")
            state.sun = sunFrom(value, state.sun);
        else if (key == "day_playing")
            state.dayPlays = value.boolean();
        else if (key == "sun_hours")
            state.sunHours = value.boolean();
        else if (key == "sun_hours_step")
            state.sunHoursStep = stepFrom(value);
        else if (key == "ambient")
            state.ambient = static_cast<float>(value.number(0.0, 1.0));
        else if (key == "shading")
            state.shading = value.oneOf(words::shading);
        else if (key == "exposure")
            state.exposure = static_cast<float>(value.number(-mostExposure, mostExposure));
        else if (key == "background")
            state.background = glm::vec3(value.place<3>(0.0, 1.0));
        else if (key == "ground")
            state.ground = groundFrom(value);
        else if (key == "cast_cutouts")
            state.castCutouts = value.boolean();
        else if (key == "cull")
            state.culls = value.oneOf(cullWords);
        else if (key == "left")
            state.left = sideFrom(value, state.left);
        else if (key == "right")
            state.right = sideFrom(value, state.right);
        else if (key == "split")
            state.split = value.boolean();
        else if (key == "split_at")
            state.splitAt = value.number(0.0, 1.0);
        else if (key == "debug")
            state.debug = value.oneOf(debugWords);
        else if (key == "show_lights")
            state.showLights = value.boolean();
        else if (key == "animation")
            state.animation = static_cast<std::size_t>(value.integer(0, mostAnimations));
        else if (key == "playing")
            state.playing = value.boolean();
        else if (key == "speed")
            state.speed = value.number(slowest, fastest);
        else if (key == "time")
            state.time = value.number(0.0, longestTime);
        else
            return key == "lights";
        return true;
    });
    return state;
}

} // namespace edgeshade::viewer
