#include "src/viewer/view_state.hpp"

#include "preprocess/base/error.hpp"

#include <array>
#include <cmath>

namespace edgeshade::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr double farthestPlace = 1e12; // of a coordinate; beyond it floats lose the scene
constexpr int smallestMap = 16;
constexpr int largestMap = 16384;

template <class Value, std::size_t N>
using Words = std::array<std::pair<const char*, Value>, N>;

constexpr Words<ShadowMethod, 5> shadowWords = {{{"auto", ShadowMethod::automatic},
                                                 {"volumes", ShadowMethod::volumes},
                                                 {"primitive-map", ShadowMethod::primitiveMap},
                                                 {"map", ShadowMethod::map},
                                                 {"none", ShadowMethod::none}}};
constexpr Words<MultiplicityMethod, 4> multiplicityWords = {
    {{"plane", MultiplicityMethod::plane},
     {"reference-edge", MultiplicityMethod::referenceEdge},
     {"three-edge", MultiplicityMethod::threeEdge},
     {"single-edge", MultiplicityMethod::singleEdge}}};
constexpr Words<Shading, 2> shadingWords = {{{"full", Shading::full}, {"base", Shading::base}}};
constexpr Words<DebugView, 2> debugWords = {
    {{"none", DebugView::none}, {"volumes", DebugView::volumes}}};

template <class Value, std::size_t N>
const char* wordOf(const Words<Value, N>& words, Value value) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    return "";
}

/// A value of the state and its name, for messages.
class Field {
  public:
    Field(std::string name, const Json& value) : name_(std::move(name)), value_(value) {}

    [[noreturn]] void fail(const std::string& wanted) const {
        throw Error(ExitStatus::usage, name_ + " is " + text() + ", but must be " + wanted + ".");
    }

    /// Calls read(key, Field) for every member; it returns false for a key that it doesn't know.
    template <class Read>
    void forEachMember(Read read) const {
        if (!value_.is_object()) fail("an object");
        for (const auto& [key, value] : value_.items()) {
            const Field member(name_ == rootName ? key : name_ + "." + key, value);
            if (!read(key, member))
                throw Error(ExitStatus::usage, "There is no '" + member.name_ +
                                                   "' in a view's state (its value is " +
                                                   member.text() + ").");
        }
    }

    /// Calls read(Field) for every item.
    template <class Read>
    void forEachItem(Read read) const {
        for (std::size_t i = 0; i < value_.size(); ++i)
            read(Field(name_ + "[" + std::to_string(i) + "]", value_[i]));
    }

    std::size_t arraySize() const { return value_.is_array() ? value_.size() : 0; }

    double number(double low, double high) const {
        const double number = value_.is_number() ? value_.get<double>() : NAN;
        if (!(number >= low && number <= high)) // false for what is no number too
            fail("a number from " + Json(low).dump() + " to " + Json(high).dump());
        return number;
    }

    int integer(int low, int high) const {
        const double asNumber = number(low, high);
        if (asNumber != std::floor(asNumber)) fail("a whole number");
        return static_cast<int>(asNumber);
    }

    bool boolean() const {
        if (!value_.is_boolean()) fail("true or false");
        return value_.get<bool>();
    }

    template <class Value, std::size_t N>
    Value oneOf(const Words<Value, N>& words) const {
        std::string all;
        for (const auto& [word, meaning] : words) {
            if (value_ == word) return meaning;
            all += (all.empty() ? "" : ", ") + std::string(word);
        }
        fail("one of " + all);
    }

    template <int N>
    glm::vec<N, double> place(double low = -farthestPlace, double high = farthestPlace) const {
        if (arraySize() != N) fail("an array of " + std::to_string(N) + " numbers");
        glm::vec<N, double> result;
        glm::length_t i = 0;
        forEachItem([&](const Field& item) { result[i++] = item.number(low, high); });
        return result;
    }

    static constexpr const char* rootName = "the view's state";

  private:
    std::string text() const {
        if (value_.is_number_float() && !std::isfinite(value_.get<double>())) return "not finite";
        constexpr std::size_t longest = 60;
        std::string text = value_.dump(-1, ' ', true, Json::error_handler_t::replace);
        if (text.size() > longest) text = text.substr(0, longest) + "...";
        return text;
    }

    std::string name_;
    const Json& value_;
};

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

std::vector<Light> lightsFrom(const Field& field) {
    if (field.arraySize() < 1 || field.arraySize() > mostLights)
        field.fail("an array of 1 to " + std::to_string(mostLights) + " lights");
    std::vector<Light> lights;
    field.forEachItem([&](const Field& item) {
        Light light;
        const bool ranged = item.arraySize() == 5;
        glm::length_t i = 0;
        const auto read = [&](const Field& number) {
            if (i == 4)
                light.range = number.number(0.0, farthestPlace);
            else
                light.position[i] = number.number(-farthestPlace, farthestPlace);
            ++i;
        };
        if (ranged)
            item.forEachItem(read);
        else
            light.position = item.place<4>();
        const glm::dvec4& position = light.position;
        if (position.w != 0.0 && position.w != 1.0)
            item.fail("a light [x, y, z, w] whose w is 0 (a sun) or 1 (a point)");
        if (position == glm::dvec4(0.0)) item.fail("a sun with a direction");
        if (ranged && (position.w == 0.0 || light.range == 0.0))
            item.fail("a point light [x, y, z, 1, range] whose range is above 0");
        lights.push_back(light);
    });
    return lights;
}

int maskScaleFrom(const Field& field) {
    const int scale = field.integer(1, 4);
    if (scale == 3) field.fail("1, 2 or 4");
    return scale;
}

SideSettings sideFrom(const Field& field, SideSettings side) {
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "shadows")
            side.shadows = value.oneOf(shadowWords);
        else if (key == "map_size")
            side.mapSize = value.integer(smallestMap, largestMap);
        else if (key == "multiplicity")
            side.multiplicity = value.oneOf(multiplicityWords);
        else if (key == "mask_scale")
            side.maskScale = maskScaleFrom(value);
        else
            return false;
        return true;
    });
    return side;
}

Json toJson(const SideSettings& side) {
    return {{"shadows", wordOf(shadowWords, side.shadows)},
            {"map_size", side.mapSize},
            {"multiplicity", wordOf(multiplicityWords, side.multiplicity)},
            {"mask_scale", side.maskScale}};
}

/// The number as a person types it: 0.35, where the float nearest to it is 0.34999999.
double shortDecimal(float value) {
    return std::round(static_cast<double>(value) * 1e6) / 1e6;
}

Json toJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json toJson(const glm::vec3& color) {
    return {shortDecimal(color.r), shortDecimal(color.g), shortDecimal(color.b)};
}

} // namespace

Json toJson(const ViewState& state) {
    Json lights = Json::array();
    for (const Light& light : state.lights) {
        lights.push_back({light.position.x, light.position.y, light.position.z, light.position.w});
        if (light.hasRange()) lights.back().push_back(light.range);
    }
    return {{"camera",
             {{"from", toJson(state.camera.from)},
              {"to", toJson(state.camera.to)},
              {"fov", state.camera.fovDegrees}}},
            {"lights", lights},
            {"chosen_light", state.chosenLight},
            {"shading", wordOf(shadingWords, state.shading)},
            {"ambient", shortDecimal(state.ambient)},
            {"exposure", shortDecimal(state.exposure)},
            {"background", toJson(state.background)},
            {"left", toJson(state.left)},
            {"right", toJson(state.right)},
            {"split", state.split},
            {"split_at", state.splitAt},
            {"debug", wordOf(debugWords, state.debug)},
            {"show_lights", state.showLights},
            {"playing", state.playing},
            {"speed", state.speed},
            {"time", state.time}};
}

ViewState changed(const ViewState& base, const Json& changes) {
    ViewState state = base;
    const Field root(Field::rootName, changes);
    // The lights come first: they decide which can be chosen.
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
        else if (key == "ambient")
            state.ambient = static_cast<float>(value.number(0.0, 1.0));
        else if (key == "shading")
            state.shading = value.oneOf(shadingWords);
        else if (key == "exposure")
            state.exposure = static_cast<float>(value.number(-mostExposure, mostExposure));
        else if (key == "background")
            state.background = glm::vec3(value.place<3>(0.0, 1.0));
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
