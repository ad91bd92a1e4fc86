#include "src/viewer/view_state.hpp"

#include "src/settings/settings.hpp"
#include "src/viewer/light_state.hpp"
#include "src/viewer/section_state.hpp"

#include <algorithm>
#include <type_traits>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr Words<DebugView, 2> debugWords = {
    {{"none", DebugView::none}, {"volumes", DebugView::volumes}}};

/// Values that read() and written() know by their type.
struct Own {};

/// Minutes that divide a day.
struct DayDivisor {};

/// The number as a person types it, for example 0.35, whose nearest float is 0.34999999.
double shortDecimal(float value) {
    return std::round(static_cast<double>(value) * 1e6) / 1e6;
}

/// Calls use(setting, member) for every member of a state or a side, in the order of its JSON.
template <class State, class Use>
void forEachMember(State& state, Use use) {
    if constexpr (std::is_same_v<std::remove_const_t<State>, SideSettings>) {
        forEachSideSetting(use, state);
    } else {
        use(Setting{"camera", Own{}}, state.camera);
        use(Setting{"lights", Own{}}, state.lights);
        const auto lights = static_cast<std::int64_t>(state.lights.size()); // those just read
        use(Setting{"chosen_light", WholeRange{0, std::max<std::int64_t>(lights - 1, 0)}},
            state.chosenLight);
        use(settings::lightSamples, state.lightSamples);
        use(settings::smooth, state.smooth);
        use(Setting{"sun", Own{}}, state.sun);
        use(Setting{"day_playing", Own{}}, state.dayPlays);
        use(Setting{"sun_hours", Own{}}, state.sunHours);
        use(Setting{"sun_hours_step", DayDivisor{}}, state.sunHoursStep);
        use(settings::shading, state.shading);
        use(settings::ambient, state.ambient);
        use(settings::exposure, state.exposure);
        use(Setting{"background", Own{}}, state.background);
        use(Setting{"ground", Own{}}, state.ground);
        use(Setting{"section", Own{}}, state.section);
        use(Setting{"cast_cutouts", Own{}}, state.castCutouts);
        use(settings::cull, state.culls);
        use(Setting{"left", Own{}}, state.left);
        use(Setting{"right", Own{}}, state.right);
        use(Setting{"split", Own{}}, state.split);
        use(Setting{"split_at", NumberRange{0.0, 1.0}}, state.splitAt);
        use(Setting{"debug", debugWords}, state.debug);
        use(Setting{"show_lights", Own{}}, state.showLights);
        use(Setting{"animation", WholeRange{0, mostAnimations}}, state.animation);
        use(Setting{"playing", Own{}}, state.playing);
        use(Setting{"speed", NumberRange{slowest, fastest}}, state.speed);
        use(Setting{"time", NumberRange{0.0, longestTime}}, state.time);
    }
}

// Reading a member's value.

template <class Domain, class Value>
void read(const Field& field, const Domain& domain, Value& value) {
    value = static_cast<Value>(field.in(domain));
}

void read(const Field& field, DayDivisor, int& minutes) {
    constexpr int day = 24 * 60;
    minutes = field.integer(1, day);
    if (day % minutes != 0) field.fail("minutes that divide a day");
}

template <class State>
void readMembers(const Field& field, State& state) {
    std::vector<std::string_view> keys;
    forEachMember(state, [&](const auto& setting, auto& value) {
        keys.push_back(setting.key);
        if (const auto member = field.member(setting.key)) read(*member, setting.domain, value);
    });
    field.requireMembersAmong(keys);
}

void read(const Field& field, Own, Camera& camera) {
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "from")
            camera.from = value.place<3>();
        else if (key == "to")
            camera.to = value.place<3>();
        else if (key == "fov")
            camera.fovDegrees = value.number(0.0, 180.0);
        else
            return false;
        if (camera.fovDegrees == 0.0 || camera.fovDegrees == 180.0)
            value.fail("above 0 and below 180");
        return true;
    });
    if (camera.from == camera.to) field.fail("a camera whose 'from' and 'to' differ");
}
void read(const Field& field, Own, std::vector<Light>& lights) {
    if (field.arraySize() < 1 || field.arraySize() > mostLights)
        field.fail("an array of 1 to " + std::to_string(mostLights) + " lights");
    lights.clear();
    field.forEachItem([&](const Field& item) { lights.push_back(lightFrom(item)); });
}
void read(const Field& field, Own, std::optional<SunState>& sun) {
    sun = sunFrom(field, sun);
}
void read(const Field& field, Own, bool& is) {
    is = field.boolean();
}
void read(const Field& field, Own, glm::vec3& color) {
    color = glm::vec3(field.place<3>(0.0, 1.0));
}
void read(const Field& field, Own, GroundChoice& choice) {
    const auto ground = groundFromText(field.word());
    if (!ground) field.fail("off, catcher or a colour #rrggbb");
    choice = *ground;
}
void read(const Field& field, Own, std::optional<Section>& section) {
    section = sectionFrom(field);
}
void read(const Field& field, Own, SideSettings& side) {
    readMembers(field, side);
}

// Writing it.

template <class Domain, class Value>
Json written(const Domain&, const Value& value) {
    if constexpr (std::is_same_v<Value, float>)
        return shortDecimal(value);
    else if constexpr (std::is_arithmetic_v<Value>)
        return value;
    else
        return toJson(value);
}
template <class Value, std::size_t N>
Json written(const Words<Value, N>& words, Value value) {
    return wordOf(words, value);
}
template <std::size_t N>
Json written(const Words<int, N>&, int value) {
    return value;
}

template <class State>
Json writtenMembers(const State& state) {
    Json json;
    forEachMember(state, [&](const auto& setting, const auto& value) {
        json[setting.key] = written(setting.domain, value);
    });
    return json;
}

Json written(Own, const std::vector<Light>& lights) {
    Json json = Json::array();
    for (const Light& light : lights)
        json.push_back(toJson(light));
    return json;
}
Json written(Own, const glm::vec3& color) {
    return {shortDecimal(color.r), shortDecimal(color.g), shortDecimal(color.b)};
}
Json written(Own, const GroundChoice& ground) {
    return textOf(ground);
}
Json written(Own, const SideSettings& side) {
    return writtenMembers(side);
}

} // namespace

Json toJson(const Camera& camera) {
    return {{"from", toJson(camera.from)}, {"to", toJson(camera.to)}, {"fov", camera.fovDegrees}};
}

Json toJson(const ViewState& state) {
    return writtenMembers(state);
}

ViewState changed(const ViewState& base, const Json& changes) {
    ViewState state = base;
    readMembers(Field(Field::rootName, changes), state);
    state.chosenLight =
        std::min(state.chosenLight, std::max<std::size_t>(state.lights.size(), 1) - 1);
    return state;
}

} // namespace edgeshade::viewer
