#include "preprocess/gltf/gltf_checks.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/extensions.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/gltf/utf8.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <utility>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t deepestNesting = 500; // far more than glTF needs, and safe for the stack

/// Most members of one object. An object keeps its order and is searched linearly, so that the time
/// grows with the square of their number. Tables in extras are large, glTF's own objects are not.
constexpr std::size_t mostMembers = 10000;

/// Bytes that a JSON value takes in all its representations, without its text.
constexpr std::size_t bytesPerValue = 256;

/// Properties of JSON text that are known before parsing.
struct JsonShape {
    std::size_t depth = 0;   ///< deepest nesting of brackets and braces outside strings
    std::size_t members = 0; ///< of the object with the most
    std::size_t values = 1;
};

JsonShape shapeOf(std::string_view text) {
    JsonShape shape;
    std::size_t depth = 0;
    std::array<std::size_t, deepestNesting + 1> members{}; // of the current object at that depth
    for (std::size_t i = 0; i < text.size() && shape.depth <= deepestNesting; ++i) {
        const char c = text[i];
        if (c == '[' || c == '{') {
            shape.depth = std::max(shape.depth, ++depth);
            ++shape.values;
            if (depth <= deepestNesting) members[depth] = 0;
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        } else if (c == ',') {
            ++shape.values;
        } else if (c == ':') {
            shape.members = std::max(shape.members, ++members[depth]);
        } else if (c == '"') {
            for (i = text.find_first_of("\"\\", i + 1); i < text.size() && text[i] == '\\';)
                i = text.find_first_of("\"\\", i + 2);
            if (i >= text.size()) break;
        }
    }
    return shape;
}

/// Parses "2.1" as (2, 1).
std::pair<int, int> versionOf(const JsonField& field) {
    const std::string text = field.text();
    const char* end = text.data() + text.size();
    std::pair<int, int> version;
    const auto major = std::from_chars(text.data(), end, version.first);
    const bool dotted = major.ec == std::errc() && major.ptr != end && *major.ptr == '.';
    const auto minor = dotted ? std::from_chars(major.ptr + 1, end, version.second) : major;
    if (!dotted || minor.ec != std::errc() || minor.ptr != end)
        field.fail(" is '" + text + "', which is not a version");
    return version;
}

void checkAsset(const JsonField& asset) {
    const JsonField version = asset.member("version");
    if (versionOf(version).first != 2)
        version.fail(" is '" + version.text() + "', but only glTF 2 is read");
    asset.ifPresent("minVersion", [](const JsonField& least) {
        if (versionOf(least) > std::pair(2, 0))
            least.fail(" is '" + least.text() + "', but this program reads at most glTF 2.0");
    });
}

void checkIndex(const JsonField& object, const char* key) {
    object.ifPresent(key, [](const JsonField& field) { field.index(); });
}

void checkWholeNumber(const JsonField& object, const char* key) {
    object.ifPresent(key, [](const JsonField& field) { field.wholeNumber(); });
}

void checkText(const JsonField& object, const char* key) {
    object.ifPresent(key, [](const JsonField& field) { field.text(); });
}

void checkIntegers(const JsonField& array) {
    array.forEachItem([](const JsonField& item) { item.integer(); });
}

/// Checks the member, if present, by JsonField::numbers().
void checkNumbers(const JsonField& object, const char* key, std::size_t count) {
    object.ifPresent(key, [count](const JsonField& array) { array.numbers(count); });
}

void checkBuffer(const JsonField& buffer) {
    buffer.member("byteLength").wholeNumber();
    checkText(buffer, "uri");
}

/// Checks a range of a buffer, in a view or in a compressed view.
void checkRange(const JsonField& range, std::size_t bufferCount) {
    range.member("buffer").indexInto(bufferCount, "buffers");
    checkWholeNumber(range, "byteOffset");
    range.member("byteLength").wholeNumber();
    checkWholeNumber(range, "byteStride");
}

void checkBufferView(const JsonField& view, std::size_t bufferCount) {
    checkRange(view, bufferCount);
    view.ifPresent("byteStride", [](const JsonField& stride) {
        const std::uint64_t value = stride.wholeNumber();
        if (value < 4 || value > 252 || value % 4 != 0)
            stride.fail(" is " + std::to_string(value) +
                        ", but must be a multiple of 4 from 4 to 252");
    });
    view.ifPresent("extensions", [&](const JsonField& extensions) {
        extensions.forEachMember([&](const JsonField& extension) {
            if (extension.value().is_object() && extension.find("buffer"))
                checkRange(extension, bufferCount);
        });
    });
}

void checkSparse(const JsonField& sparse, std::size_t viewCount) {
    sparse.member("count").index();
    for (const char* key : {"indices", "values"}) {
        const JsonField part = sparse.member(key);
        part.member("bufferView").indexInto(viewCount, "bufferViews");
        checkIndex(part, "byteOffset"); // an int in tinygltf
    }
    sparse.member("indices").member("componentType").index();
}

void checkAccessor(const JsonField& accessor, std::size_t viewCount) {
    accessor.ifPresent("bufferView",
                       [&](const JsonField& view) { view.indexInto(viewCount, "bufferViews"); });
    checkWholeNumber(accessor, "byteOffset");
    accessor.member("count").wholeNumber();
    accessor.ifPresent("normalized", [](const JsonField& flag) { flag.boolean(); });
    const JsonField componentType = accessor.member("componentType");
    if (componentType.index() < 5120 || componentType.index() > 5130)
        componentType.fail(" is " + std::to_string(componentType.index()) +
                           ", which is not a component type");
    const JsonField type = accessor.member("type");
    constexpr std::array types = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    if (std::find(types.begin(), types.end(), type.text()) == types.end())
        type.fail(" is '" + type.text() + "', which is not an accessor type");
    accessor.ifPresent("sparse", [&](const JsonField& sparse) { checkSparse(sparse, viewCount); });
}

void checkDraco(const JsonField& extension, std::size_t viewCount) {
    extension.member("bufferView").indexInto(viewCount, "bufferViews");
    extension.member("attributes").forEachMember([](const JsonField& id) { id.index(); });
}

void checkAttributes(const JsonField& attributes, std::size_t accessorCount) {
    attributes.forEachMember(
        [&](const JsonField& accessor) { accessor.indexInto(accessorCount, "accessors"); });
}

void checkPrimitive(const JsonField& primitive, std::size_t accessorCount, std::size_t viewCount) {
    checkAttributes(primitive.member("attributes"), accessorCount);
    primitive.ifPresent("indices", [&](const JsonField& accessor) {
        accessor.indexInto(accessorCount, "accessors");
    });
    checkIndex(primitive, "material");
    primitive.ifPresent("mode", [](const JsonField& mode) {
        if (mode.index() > 6) mode.fail(" is " + mode.value().dump() + ", but must be 0 to 6");
    });
    primitive.ifPresent("targets", [&](const JsonField& targets) {
        targets.forEachItem(
            [&](const JsonField& target) { checkAttributes(target, accessorCount); });
    });
    primitive.ifExtension("KHR_draco_mesh_compression",
                          [&](const JsonField& extension) { checkDraco(extension, viewCount); });
}

void checkNode(const JsonField& node, std::size_t accessorCount) {
    checkIndex(node, "mesh");
    checkIndex(node, "skin");
    checkNumbers(node, "matrix", 16);
    checkNumbers(node, "translation", 3);
    checkNumbers(node, "rotation", 4);
    checkNumbers(node, "scale", 3);
    checkNumbers(node, "weights", 0);
    node.ifPresent("children", checkIntegers);
    node.ifExtension("EXT_mesh_gpu_instancing", [&](const JsonField& instancing) {
        instancing.requireObject();
        instancing.ifPresent("attributes", [&](const JsonField& attributes) {
            checkAttributes(attributes, accessorCount);
        });
    });
    node.ifExtension("KHR_node_visibility", [](const JsonField& visibility) {
        visibility.ifPresent("visible", [](const JsonField& flag) { flag.boolean(); });
    });
}

void checkTextureInfo(const JsonField& info) {
    info.member("index").index();
    checkIndex(info, "texCoord");
    info.ifExtension("KHR_texture_transform", [](const JsonField& transform) {
        checkIndex(transform, "texCoord");
        checkNumbers(transform, "offset", 2);
        checkNumbers(transform, "scale", 2);
        transform.ifPresent("rotation", [](const JsonField& angle) { angle.number(); });
    });
}

void checkMaterial(const JsonField& material) {
    material.ifPresent("alphaMode", [](const JsonField& mode) {
        mode.oneOf({"OPAQUE", "MASK", "BLEND"});
    });
    material.ifPresent("alphaCutoff", [](const JsonField& cutoff) { cutoff.number(); });
    material.ifPresent("pbrMetallicRoughness", [](const JsonField& metallic) {
        checkNumbers(metallic, "baseColorFactor", 4);
        metallic.ifPresent("baseColorTexture", checkTextureInfo);
    });
    material.ifExtension("KHR_materials_pbrSpecularGlossiness", [](const JsonField& glossy) {
        checkNumbers(glossy, "diffuseFactor", 4);
        glossy.ifPresent("diffuseTexture", checkTextureInfo);
    });
    material.ifExtension("KHR_materials_unlit",
                         [](const JsonField& unlit) { unlit.requireObject(); });
}

/// `meaning`: the allowed values, in words.
void checkOneOf(const JsonField& object, const char* key, std::initializer_list<int> values,
                const std::string& meaning) {
    object.ifPresent(key, [&](const JsonField& field) {
        const int value = field.index();
        if (std::find(values.begin(), values.end(), value) == values.end())
            field.fail(" is " + std::to_string(value) + ", but must be " + meaning);
    });
}

void checkSampler(const JsonField& sampler) {
    for (const char* key : {"wrapS", "wrapT"})
        checkOneOf(sampler, key, {33071, 33648, 10497},
                   "33071, 33648 or 10497: clamp, mirror or repeat");
    checkOneOf(sampler, "magFilter", {9728, 9729}, "9728 or 9729: nearest or linear");
    checkOneOf(sampler, "minFilter", {9728, 9729, 9984, 9985, 9986, 9987},
               "9728, 9729 or 9984 to 9987: nearest or linear, with or without mipmaps");
}

/// Requires a section, if present, to be an array of objects; `check` checks each object.
template <class Check>
void checkSection(const JsonField& root, const char* section, Check check) {
    root.ifPresent(section, [&](const JsonField& items) {
        items.forEachItem([&](const JsonField& item) {
            item.requireObject();
            check(item);
        });
    });
}

void checkSections(const JsonField& root) {
    const std::size_t bufferCount = root.countOf("buffers");
    const std::size_t viewCount = root.countOf("bufferViews");
    const std::size_t accessorCount = root.countOf("accessors");
    const std::size_t samplerCount = root.countOf("samplers");
    checkSection(root, "buffers", checkBuffer);
    checkSection(root, "bufferViews",
                 [&](const JsonField& view) { checkBufferView(view, bufferCount); });
    checkSection(root, "accessors",
                 [&](const JsonField& accessor) { checkAccessor(accessor, viewCount); });
    checkSection(root, "meshes", [&](const JsonField& mesh) {
        checkNumbers(mesh, "weights", 0);
        mesh.member("primitives").forEachItem([&](const JsonField& primitive) {
            checkPrimitive(primitive, accessorCount, viewCount);
        });
    });
    checkSection(root, "nodes", [&](const JsonField& node) { checkNode(node, accessorCount); });
    checkSection(root, "scenes",
                 [](const JsonField& scene) { scene.ifPresent("nodes", checkIntegers); });
    checkSection(root, "skins", [&](const JsonField& skin) {
        checkIntegers(skin.member("joints"));
        skin.ifPresent("inverseBindMatrices", [&](const JsonField& matrices) {
            matrices.indexInto(accessorCount, "accessors");
        });
    });
    checkSection(root, "materials", checkMaterial);
    checkSection(root, "samplers", checkSampler);
    checkSection(root, "textures", [&](const JsonField& texture) {
        texture.ifPresent("sampler", [&](const JsonField& sampler) {
            sampler.indexInto(samplerCount, "samplers");
        });
    });
    checkSection(root, "images", [](const JsonField&) {}); // checked when they are decoded
    checkIndex(root, "scene");
    root.ifExtension("CESIUM_RTC",
                     [](const JsonField& extension) { extension.member("center").numbers(3); });
}

/// The error in text that isn't JSON.
std::string jsonFault(std::string_view text, std::size_t byte, bool inGlb) {
    // skips a UTF-8 byte order mark too
    const std::size_t start = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    const bool begun =
        start != std::string_view::npos && (text[start] == '{' || text[start] == '[');
    if (!inGlb && !begun) return " is neither GLB nor JSON.";
    return " holds invalid JSON at byte " + std::to_string(byte) +
           (byte > text.size() ? ": it ends too early." : ": that byte is not allowed there.");
}

} // namespace

nlohmann::ordered_json parseJson(std::string_view text, const std::filesystem::path& path,
                                 bool inGlb, MemoryBudget& memory, Warnings& warnings) {
    const std::string file = "'" + path.string() + "'";
    const JsonShape shape = shapeOf(text);
    if (shape.depth > deepestNesting)
        throw InputError(file + " nests its JSON more than " + std::to_string(deepestNesting) +
                         " levels deep.");
    if (shape.members > mostMembers)
        throw InputError(file + " has a JSON object of " + std::to_string(shape.members) +
                         " members; at most " + std::to_string(mostMembers) + " are read.");
    memory.take(text.size() + bytesPerValue * shape.values, 1, file + ": its JSON");
    std::string replaced;
    if (const auto invalid = firstInvalidUtf8(text)) {
        warnings.add(file + " holds text that is not UTF-8, first at byte " +
                     std::to_string(*invalid) + " of its JSON; each such byte is read as U+FFFD.");
        memory.take(3 * text.size(), 1, file + ": its JSON");
        text = replaced = withValidUtf8(text);
    }
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw InputError(file + jsonFault(text, error.byte, inGlb));
    }
}

void requireSoundGltf(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                      Warnings& warnings) {
    if (!json.is_object()) throw InputError("'" + path.string() + "' holds no JSON object.");
    const JsonField root(path, json);
    checkAsset(root.member("asset"));
    checkExtensions(root, warnings);
    checkSections(root);
}

void requireWithinLimits(const nlohmann::ordered_json& json, const std::filesystem::path& path,
                         MemoryBudget& memory) {
    constexpr std::size_t bytesPerItem = 2048; // a typed material has 1,500
    const JsonField root(path, json);
    root.ifPresent("nodes", [&](const JsonField& nodes) {
        if (nodes.size() > memory.limits().nodes)
            nodes.fail(" has " + std::to_string(nodes.size()) + " items, but the limit is " +
                       std::to_string(memory.limits().nodes));
    });
    root.forEachMember([&](const JsonField& section) {
        if (section.value().is_array())
            memory.take(section.size(), bytesPerItem, "'" + path.string() + "': " + section.name());
    });
}

} // namespace edgeshade
