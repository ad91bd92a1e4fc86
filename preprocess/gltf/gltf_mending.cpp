#include "preprocess/gltf/gltf_mending.hpp"

#include "preprocess/gltf/json_field.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// Fields that hold a whole number or an array of them, anywhere in glTF or an extension; sorted.
constexpr std::string_view wholeNumberKeys[] = {
    "buffer",
    "bufferView",
    "byteLength",
    "byteOffset",
    "byteStride",
    "camera",
    "caps",
    "children",
    "componentType",
    "count",
    "edgeCount",
    "edgeVertices",
    "index",
    "indices",
    "input",
    "inverseBindMatrices",
    "joints",
    "light",
    "magFilter",
    "material",
    "maxMultiplicity",
    "mesh",
    "minFilter",
    "mode",
    "node",
    "nodes",
    "oppositeCounts",
    "oppositeVertices",
    "output",
    "sampler",
    "scene",
    "sides",
    "simplifiedCasters",
    "simplifiedTriangles",
    "skeleton",
    "skin",
    "source",
    "target",
    "texCoord",
    "variants",
    "version",
    "wrapS",
    "wrapT",
};

/// Turns a float such as 96.0 into an integer. Leaves other values, and floats beyond 2^53,
/// unchanged.
void makeWhole(Json& value) {
    if (!value.is_number_float()) return;
    const auto number = value.get<double>();
    constexpr double most = 9007199254740992.0; // 2^53
    if (std::abs(number) <= most && number == std::trunc(number))
        value = static_cast<std::int64_t>(number);
}

void mendNumbers(Json& value);

/// Makes a field's value, or each number among its items, whole, as in an attribute list.
void mendWholeNumbers(Json& value) {
    if (!value.is_structured()) return makeWhole(value);
    for (Json& item : value) {
        makeWhole(item);
        mendNumbers(item);
    }
}

void mendNumbers(Json& value) {
    if (value.is_array())
        for (Json& item : value)
            mendNumbers(item);
    if (!value.is_object()) return;
    for (auto member = value.begin(); member != value.end(); ++member) {
        const std::string& key = member.key();
        if (key == "extras") continue;              // only others define its meaning
        if (key == "targets" && member->is_array()) // morph targets: attribute lists
            for (Json& attributes : *member)
                mendWholeNumbers(attributes);
        else if (key == "attributes" ||
                 std::binary_search(std::begin(wholeNumberKeys), std::end(wholeNumberKeys), key))
            mendWholeNumbers(*member);
        else
            mendNumbers(*member);
    }
}

void dropZeroStrides(Json& json) {
    const auto views = json.find("bufferViews");
    if (views == json.end() || !views->is_array()) return;
    for (Json& view : *views)
        if (view.is_object() && view.contains("byteStride") && view["byteStride"] == 0)
            view.erase("byteStride");
}

/// Drops names that aren't text; only items of sections have names.
void dropBrokenNames(Json& json, const std::filesystem::path& path, Warnings& warnings) {
    const JsonField root(path, json);
    for (auto section = json.begin(); section != json.end(); ++section) {
        if (!section->is_array()) continue;
        const JsonField items = root.member(section.key().c_str());
        std::size_t index = 0;
        items.forEachItem([&](const JsonField& item) {
            Json& mended = (*section)[index++];
            if (!item.value().is_object() || !item.value().contains("name")) return;
            if (!readOrWarn(warnings, "the name is left out", [&] { item.member("name").text(); }))
                mended.erase("name");
        });
    }
}

} // namespace

void mendGltf(Json& json, const std::filesystem::path& path, Warnings& warnings) {
    if (!json.is_object()) return;
    for (auto section = json.begin(); section != json.end(); ++section) {
        if (section.key() == "asset" || section.key() == "extras") continue;
        if (section.key() == "scene")
            makeWhole(*section);
        else
            mendNumbers(*section);
    }
    dropZeroStrides(json);
    dropBrokenNames(json, path, warnings);
}

} // namespace edgeshade
