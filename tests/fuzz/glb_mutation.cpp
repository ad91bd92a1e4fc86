#include "tests/fuzz/glb_mutation.hpp"

#include "preprocess/gltf/glb.hpp"

#include <algorithm>
#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t mostSize);

namespace edgeshade::test {
namespace {

using Random = std::minstd_rand;

std::size_t below(Random& random, std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

/// Collects every value from `root` down.
void collect(Json& root, std::vector<Json*>& values) {
    values.push_back(&root);
    if (root.is_structured())
        for (Json& child : root)
            collect(child, values);
}

std::vector<Json*> valuesUnder(const std::vector<Json*>& roots) {
    std::vector<Json*> values;
    for (Json* root : roots)
        collect(*root, values);
    return values;
}

/// Numbers at the limits of types, and sizes beyond those present.
Json oddNumber(Random& random) {
    static const std::vector<Json> numbers = {0,
                                              1,
                                              2,
                                              3,
                                              4,
                                              5,
                                              255,
                                              256,
                                              65535,
                                              65536,
                                              2147483647,
                                              2147483648,
                                              -1,
                                              -2,
                                              0.5,
                                              4294967295,
                                              4294967296,
                                              1e30,
                                              1e300,
                                              -1e300,
                                              1e-40,
                                              16777216,
                                              5120,
                                              5121,
                                              5123,
                                              5125,
                                              5126,
                                              100,
                                              1000,
                                              1000000,
                                              -0.0,
                                              1e18,
                                              -1e18,
                                              7,
                                              12,
                                              1099511627776,
                                              9223372036854775807,
                                              18446744073709551615u};
    return numbers[below(random, numbers.size())];
}

const std::vector<std::string>& words() {
    static const std::vector<std::string> all = {"POSITION",
                                                 "NORMAL",
                                                 "TEXCOORD_0",
                                                 "COLOR_0",
                                                 "JOINTS_0",
                                                 "WEIGHTS_0",
                                                 "SCALAR",
                                                 "VEC2",
                                                 "VEC3",
                                                 "VEC4",
                                                 "MAT4",
                                                 "MASK",
                                                 "BLEND",
                                                 "OPAQUE",
                                                 "STEP",
                                                 "LINEAR",
                                                 "CUBICSPLINE",
                                                 "translation",
                                                 "rotation",
                                                 "scale",
                                                 "weights",
                                                 "ATTRIBUTES",
                                                 "TRIANGLES",
                                                 "INDICES",
                                                 "NONE",
                                                 "OCTAHEDRAL",
                                                 "QUATERNION",
                                                 "EXPONENTIAL",
                                                 "expanded",
                                                 "indexed",
                                                 "none",
                                                 "2.0",
                                                 "KHR_draco_mesh_compression",
                                                 "EXT_meshopt_compression",
                                                 "EDGESHADE_shadow_volume",
                                                 "KHR_texture_transform",
                                                 "data:,",
                                                 "data:image/webp;base64,UklGRgA=",
                                                 "data:image/png;base64,iVBORw0KGgo=",
                                                 "mimeType",
                                                 "image/png",
                                                 "bufferView",
                                                 "byteOffset",
                                                 "byteLength",
                                                 "byteStride",
                                                 "count",
                                                 "mode",
                                                 "mesh",
                                                 "skin",
                                                 "children",
                                                 "matrix",
                                                 "sparse",
                                                 "indices",
                                                 "values",
                                                 "targets",
                                                 "material",
                                                 "attributes",
                                                 "extensions",
                                                 "componentType",
                                                 "normalized",
                                                 "node",
                                                 "uri",
                                                 "data:application/octet-stream;base64,AAAA",
                                                 "edgeCount",
                                                 "simplifiedTriangles",
                                                 "simplifiedCasters",
                                                 "casterError",
                                                 "weldTolerance",
                                                 "flatTolerance",
                                                 "castMasked",
                                                 "filter",
                                                 "buffer",
                                                 "inverseBindMatrices",
                                                 "joints",
                                                 "scene",
                                                 "max",
                                                 "min",
                                                 "",
                                                 "../a"};
    return all;
}

Json oddValue(Random& random) {
    switch (below(random, 6)) {
    case 0:
        return nullptr;
    case 1:
        return below(random, 2) == 0;
    case 2:
        return Json::array();
    case 3:
        return Json::object();
    case 4:
        return words()[below(random, words().size())];
    default:
        return oddNumber(random);
    }
}

std::string textOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json nearbyNumber(const Json& number, Random& random) {
    const double value = number.get<double>();
    const bool isWhole = number.is_number_integer() && std::abs(value) < 1e15;
    if (!isWhole) return value * static_cast<double>(below(random, 5)) - 1.0;
    static const std::int64_t steps[] = {-4, -3, -2, -1, 1, 2, 3, 4, 64};
    return number.get<std::int64_t>() + steps[below(random, std::size(steps))];
}

/// Removes, repeats or adds a child of an array or object.
void changeChildren(Json& parent, const Json& another, Random& random) {
    const std::size_t kind = below(random, 3);
    if (parent.is_array()) {
        if (kind == 0 && !parent.empty())
            parent.erase(below(random, parent.size()));
        else if (kind == 1 && !parent.empty())
            parent.push_back(Json(parent[below(random, parent.size())]));
        else
            parent.push_back(another);
    } else if (kind == 0 && !parent.empty()) {
        auto child = parent.begin();
        std::advance(child, static_cast<std::ptrdiff_t>(below(random, parent.size())));
        parent.erase(child);
    } else {
        parent[words()[below(random, words().size())]] = another;
    }
}

void changeJson(Json& json, const std::vector<Json*>& roots, Random& random) {
    const std::vector<Json*> values = valuesUnder(roots);
    if (values.empty()) return;
    std::vector<Json*> anywhere;
    collect(json, anywhere);
    const Json another = *anywhere[below(random, anywhere.size())];
    Json& value = *values[below(random, values.size())];
    if (value.is_structured() && below(random, 4) != 0) {
        changeChildren(value, below(random, 2) ? another : oddValue(random), random);
    } else if (value.is_number() && below(random, 2) == 0) {
        value = nearbyNumber(value, random);
    } else if (value.is_string() && below(random, 2) == 0) {
        value = words()[below(random, words().size())];
    } else {
        value = below(random, 3) == 0 ? another : oddValue(random);
    }
}

/// Members that the root of a glTF may have.
constexpr const char* sections[] = {
    "accessors", "animations", "asset",  "bufferViews",    "buffers",
    "cameras",   "extensions", "extras", "extensionsUsed", "extensionsRequired",
    "images",    "materials",  "meshes", "nodes",          "samplers",
    "scene",     "scenes",     "skins",  "textures",
};

/// Removes, empties, adds or moves a section; `repeated` becomes the text of a member to be given
/// twice.
void changeSections(Json& json, std::string& repeated, Random& random) {
    if (!json.is_object()) return;
    const char* any = sections[below(random, std::size(sections))];
    if (json.empty() || below(random, 4) == 0) { // possibly one that is missing
        static const Json empty[] = {Json::array(), Json::object(), Json::array({Json::object()})};
        json[any] = empty[below(random, std::size(empty))];
        return;
    }
    auto member = json.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(below(random, json.size())));
    const std::string key = member.key();
    const Json value = *member;
    const std::size_t kind = below(random, 3);
    if (kind == 0)
        repeated = textOf(key) + ":" + textOf(value) + ",";
    else
        json.erase(key);
    if (kind == 1) json[key] = value; // now the last
}

bool isWholeNumber(const Json& object, const char* key) {
    return object.contains(key) && object[key].is_number_integer() &&
           object[key].get<std::int64_t>() >= 0;
}

std::size_t offsetOf(const Json& range) {
    return isWholeNumber(range, "byteOffset") ? range["byteOffset"].get<std::size_t>() : 0;
}

/// Every range of buffer 0: of views and of compressed data.
std::vector<Json*> rangesIn(Json& json) {
    std::vector<Json*> all;
    collect(json, all);
    std::erase_if(all, [](const Json* value) {
        return !value->is_object() || !isWholeNumber(*value, "byteLength") ||
               !value->contains("buffer") || (*value)["buffer"] != 0;
    });
    return all;
}

/// Puts `bytes` in the range's place; the data behind it move by multiples of four bytes.
void replaceRange(Json& json, Bytes& binary, Json& range, const Bytes& bytes) {
    const std::size_t offset = offsetOf(range);
    const std::size_t end = offset + range["byteLength"].get<std::size_t>();
    const std::size_t padded = (bytes.size() + 3) / 4 * 4, before = (end - offset + 3) / 4 * 4;
    const std::size_t oldEnd = std::min(offset + before, binary.size());
    Bytes changed(binary.begin(), binary.begin() + static_cast<std::ptrdiff_t>(offset));
    changed.insert(changed.end(), bytes.begin(), bytes.end());
    changed.resize(offset + padded);
    changed.insert(changed.end(), binary.begin() + static_cast<std::ptrdiff_t>(oldEnd),
                   binary.end());
    // A range without an offset starts at 0; giving it one could move those within it.
    for (Json* other : rangesIn(json))
        if (other != &range && isWholeNumber(*other, "byteOffset") && offsetOf(*other) >= oldEnd)
            (*other)["byteOffset"] = offsetOf(*other) - (oldEnd - offset) + padded;
    range["byteLength"] = bytes.size();
    if (json.contains("buffers") && json["buffers"].is_array() && !json["buffers"].empty() &&
        json["buffers"][0].is_object())
        json["buffers"][0]["byteLength"] = changed.size();
    binary = std::move(changed);
}

void changeBytes(Json& json, Bytes& binary, std::vector<Json*> ranges, Random& random,
                 std::size_t mostGrowth) {
    std::erase_if(ranges, [&](const Json* range) {
        const std::size_t offset = offsetOf(*range);
        return !isWholeNumber(*range, "byteLength") || offset > binary.size() ||
               (*range)["byteLength"].get<std::size_t>() > binary.size() - offset;
    });
    if (ranges.empty()) return;
    Json& range = *ranges[below(random, ranges.size())];
    const std::size_t offset = offsetOf(range), length = range["byteLength"].get<std::size_t>();
    const bool keepsLength = below(random, 2) == 0;
    Bytes bytes(length + (keepsLength ? 0 : mostGrowth));
    std::copy_n(binary.begin() + static_cast<std::ptrdiff_t>(offset), length, bytes.begin());
    if (bytes.empty()) return;
    const std::size_t changed = LLVMFuzzerMutate(bytes.data(), length, bytes.size());
    bytes.resize(keepsLength ? length : changed);
    replaceRange(json, binary, range, bytes);
}

} // namespace

std::vector<Json*> bufferViewsOf(Json& json) {
    std::vector<Json*> views;
    if (json.is_object() && json.contains("bufferViews") && json["bufferViews"].is_array())
        for (Json& view : json["bufferViews"])
            if (view.is_object()) views.push_back(&view);
    return views;
}

std::size_t mutateGlb(std::uint8_t* data, std::size_t size, std::size_t mostSize, unsigned seed,
                      const MutationScope& scope) {
    Random random(seed);
    if (scope.container && below(random, 16) == 0) return LLVMFuzzerMutate(data, size, mostSize);
    try {
        GlbParts parts(Bytes(data, data + size));
        const std::size_t room = mostSize > size ? std::min<std::size_t>(mostSize - size, 256) : 0;
        std::string repeated;
        for (std::size_t changes = 1 + below(random, 3); changes > 0; --changes)
            if (scope.sections && below(random, 4) == 0)
                changeSections(parts.json, repeated, random);
            else if (below(random, 2) == 0)
                changeJson(parts.json, scope.json(parts.json), random);
            else
                changeBytes(parts.json, parts.binary, scope.ranges(parts.json), random, room / 4);
        std::string json = textOf(parts.json);
        if (parts.json.is_object() && !parts.json.empty()) json.insert(1, repeated);
        const Bytes glb = joinGlb(std::move(json), parts.binary);
        if (glb.size() > mostSize) return LLVMFuzzerMutate(data, size, mostSize);
        std::memcpy(data, glb.data(), glb.size());
        return glb.size();
    } catch (const std::exception&) { // not a GLB, or without JSON
        return LLVMFuzzerMutate(data, size, mostSize);
    }
}

} // namespace edgeshade::test
