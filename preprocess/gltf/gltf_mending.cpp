#include "preprocess/gltf/gltf_mending.hpp"

#include "preprocess/gltf/json_field.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// What holds whole numbers, one or an array of them, wherever it stands in glTF or an extension;
/// sorted.
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

/// The whole number that 96.0 says; other values, and those that doubles don't tell apart, stay.
void makeWhole(Json& value) {
    if (!value.is_number_float()) return;
    const auto number = value.get<double>();
    constexpr double most = 9007199254740992.0; // 2^53
    if (std::abs(number) <= most && number == std::trunc(number))
        value = static_cast<std::int64_t>(number);
}

void mendNumbers(Json& value);

/// The numbers among a field's value or its items are whole ones, as those of an attribute list.
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
        if (key == "extras") continue;              // means something to others alone
        if (key == "targets" && member->is_array()) // of morphing: attribute lists
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

/// Names stand with the items of sections.
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
