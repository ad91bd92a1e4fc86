#include "tests/fuzz/gltf_structure.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

namespace edgeshade::test {
namespace {

constexpr const char* meshopt[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// The member, or null.
const Json& in(const Json& object, const char* key) {
    static const Json nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(key);
    return found == object.end() ? nothing : *found;
}

std::optional<std::uint64_t> wholeNumber(const Json& value) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (value.is_number_integer() && value.get<std::int64_t>() >= 0)
        return static_cast<std::uint64_t>(value.get<std::int64_t>());
    return std::nullopt;
}

/// The member if it is a whole number, else `otherwise`.
std::uint64_t numberIn(const Json& object, const char* key, std::uint64_t otherwise = 0) {
    return wholeNumber(in(object, key)).value_or(otherwise);
}

std::uint64_t componentBytes(const Json& componentType) {
    switch (wholeNumber(componentType).value_or(0)) {
    case 5120:
    case 5121:
        return 1;
    case 5122:
    case 5123:
        return 2;
    case 5125:
    case 5126:
        return 4;
    default:
        return 0;
    }
}

std::uint64_t componentCount(const Json& type) {
    for (const auto& [name, count] :
         {std::pair("SCALAR", 1), {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}})
        if (type == name) return static_cast<std::uint64_t>(count);
    return 0; // MAT2 and MAT3 have padding and are not used here
}

class Structure {
  public:
    explicit Structure(const Json& json) : json_(json) {}

    std::set<std::string> faults() {
        if (!in(in(json_, "asset"), "version").is_string()) fault("asset.version", "is missing");
        checkBytes();
        checkPictures();
        checkGeometry();
        checkNodes();
        checkAnimations();
        checkExtensions();
        return std::move(faults_);
    }

  private:
    void fault(const std::string& where, const char* what) { faults_.insert(where + ": " + what); }

    /// Calls check(item, where) for all items of a list, which must not be empty if it exists.
    template <class Check>
    void each(const Json& list, const std::string& where, Check check) {
        if (list.is_null()) return;
        if (!list.is_array() || list.empty()) return fault(where, "is no array, or empty");
        for (std::size_t i = 0; i < list.size(); ++i)
            check(list[i], where + "[" + std::to_string(i) + "]");
    }

    template <class Check>
    void section(const char* name, Check check) {
        each(in(json_, name), name, check);
    }

    /// Checks an index into a list, if it exists.
    void index(const Json& value, const Json& list, const std::string& where) {
        if (value.is_null()) return;
        const auto number = wholeNumber(value);
        if (!number || !list.is_array() || *number >= list.size()) fault(where, "names nothing");
    }
    void index(const Json& object, const char* key, const char* name, const std::string& where) {
        index(in(object, key), in(json_, name), where + "." + key);
    }
    void needed(const Json& object, const char* key, const std::string& where) {
        if (in(object, key).is_null()) fault(where + "." + key, "is missing");
    }
    void indices(const Json& list, const char* name, const std::string& where) {
        each(list, where, [&](const Json& item, const std::string& place) {
            index(item, in(json_, name), place);
        });
    }
    /// Checks that each member is an index.
    void indexMembers(const Json& object, const char* name, const std::string& where) {
        if (!object.is_object()) return;
        for (const auto& [key, value] : object.items())
            index(value, in(json_, name), where + "." + key);
    }

    const Json& itemOf(const char* name, const Json& number) {
        static const Json nothing;
        const Json& list = in(json_, name);
        const auto at = wholeNumber(number);
        return at && list.is_array() && *at < list.size() ? list[*at] : nothing;
    }

    /// The length of a view's part within its buffer.
    std::uint64_t lengthOf(const Json& view) {
        const std::uint64_t end = numberIn(itemOf("buffers", in(view, "buffer")), "byteLength");
        const std::uint64_t offset = std::min(numberIn(view, "byteOffset"), end);
        return std::min(numberIn(view, "byteLength"), end - offset);
    }

    /// Checks a view's range, or that of its compressed bytes.
    void checkRange(const Json& range, const std::string& where) {
        for (const char* key : {"buffer", "byteLength"})
            needed(range, key, where);
        index(range, "buffer", "buffers", where);
        const std::uint64_t length = numberIn(range, "byteLength");
        const std::uint64_t end = numberIn(itemOf("buffers", in(range, "buffer")), "byteLength");
        const std::uint64_t offset = numberIn(range, "byteOffset");
        if (length == 0 || offset > end || length > end - offset)
            fault(where, "names no bytes of its buffer");
    }

    void checkBytes() {
        section("buffers", [&](const Json& buffer, const std::string& where) {
            if (numberIn(buffer, "byteLength") == 0) fault(where, "has no bytes");
        });
        section("bufferViews", [&](const Json& view, const std::string& where) {
            checkRange(view, where);
            for (const char* name : meshopt)
                if (const Json& compressed = in(in(view, "extensions"), name);
                    !compressed.is_null())
                    checkRange(compressed, where + "." + name);
        });
        section("accessors", [&](const Json& accessor, const std::string& where) {
            checkAccessor(accessor, where);
        });
    }

    /// Checks that `count` elements of `size` bytes lie in the view.
    void checkElements(const Json& source, std::uint64_t count, std::uint64_t size,
                       std::uint64_t alignment, const std::string& where) {
        index(source, "bufferView", "bufferViews", where);
        const Json& view = itemOf("bufferViews", in(source, "bufferView"));
        if (view.is_null() || count == 0 || size == 0) return;
        const std::uint64_t offset = numberIn(source, "byteOffset");
        const std::uint64_t stride = numberIn(view, "byteStride", size);
        const std::uint64_t length = lengthOf(view);
        if (offset > length || size > length - offset ||
            (stride != 0 && (count - 1) > (length - offset - size) / stride))
            fault(where, "ends past its view");
        if ((offset + numberIn(view, "byteOffset")) % alignment != 0)
            fault(where, "is not aligned");
    }

    void checkAccessor(const Json& accessor, const std::string& where) {
        for (const char* key : {"componentType", "count", "type"})
            needed(accessor, key, where);
        const std::uint64_t bytes = componentBytes(in(accessor, "componentType"));
        if (bytes == 0) return fault(where + ".componentType", "is not known");
        const std::uint64_t size = bytes * componentCount(in(accessor, "type"));
        const std::uint64_t count = numberIn(accessor, "count");
        if (count == 0) fault(where, "has no elements");
        checkElements(accessor, count, size, bytes, where);
        const Json& sparse = in(accessor, "sparse");
        if (sparse.is_null()) return;
        const Json& at = in(sparse, "indices");
        const std::uint64_t atBytes = componentBytes(in(at, "componentType"));
        if (atBytes == 0) return fault(where + ".sparse.indices", "are of no known type");
        const std::uint64_t elements = numberIn(sparse, "count");
        checkElements(at, elements, atBytes, atBytes, where + ".sparse.indices");
        checkElements(in(sparse, "values"), elements, size, bytes, where + ".sparse.values");
    }

    void checkPictures() {
        section("images", [&](const Json& image, const std::string& where) {
            index(image, "bufferView", "bufferViews", where);
            const bool hasView = !itemOf("bufferViews", in(image, "bufferView")).is_null();
            if (hasView != in(image, "uri").is_null()) fault(where, "has no one source");
            if (hasView) needed(image, "mimeType", where);
        });
        section("samplers", [](const Json&, const std::string&) {});
        section("textures", [&](const Json& texture, const std::string& where) {
            index(texture, "source", "images", where);
            index(texture, "sampler", "samplers", where);
        });
        section("materials", [&](const Json& material, const std::string& where) {
            for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
                index(in(material, key), "index", "textures", where + "." + key);
            const Json& metallic = in(material, "pbrMetallicRoughness");
            for (const char* key : {"baseColorTexture", "metallicRoughnessTexture"})
                index(in(metallic, key), "index", "textures", where + "." + key);
        });
    }

    void checkGeometry() {
        section("meshes", [&](const Json& mesh, const std::string& where) {
            needed(mesh, "primitives", where);
            each(in(mesh, "primitives"), where + ".primitives",
                 [&](const Json& primitive, const std::string& place) {
                     needed(primitive, "attributes", place);
                     indexMembers(in(primitive, "attributes"), "accessors", place + ".attributes");
                     index(primitive, "indices", "accessors", place);
                     index(primitive, "material", "materials", place);
                     each(in(primitive, "targets"), place + ".targets",
                          [&](const Json& target, const std::string& spot) {
                              indexMembers(target, "accessors", spot);
                          });
                     index(in(in(primitive, "extensions"), "KHR_draco_mesh_compression"),
                           "bufferView", "bufferViews", place);
                 });
        });
        section("skins", [&](const Json& skin, const std::string& where) {
            needed(skin, "joints", where);
            indices(in(skin, "joints"), "nodes", where + ".joints");
            index(skin, "inverseBindMatrices", "accessors", where);
        });
    }

    void checkNodes() {
        section("nodes", [&](const Json& node, const std::string& where) {
            index(node, "mesh", "meshes", where);
            index(node, "skin", "skins", where);
            index(node, "camera", "cameras", where);
            indices(in(node, "children"), "nodes", where + ".children");
            const Json& instancing = in(in(node, "extensions"), "EXT_mesh_gpu_instancing");
            indexMembers(in(instancing, "attributes"), "accessors", where + ".attributes");
        });
        section("scenes", [&](const Json& scene, const std::string& where) {
            indices(in(scene, "nodes"), "nodes", where + ".nodes");
        });
        index(json_, "scene", "scenes", "");
        section("cameras", [&](const Json& camera, const std::string& where) {
            needed(camera, "type", where);
        });
    }

    void checkAnimations() {
        section("animations", [&](const Json& animation, const std::string& where) {
            for (const char* key : {"samplers", "channels"})
                needed(animation, key, where);
            each(in(animation, "samplers"), where + ".samplers",
                 [&](const Json& sampler, const std::string& place) {
                     for (const char* key : {"input", "output"})
                         index(sampler, key, "accessors", place);
                 });
            each(in(animation, "channels"), where + ".channels",
                 [&](const Json& channel, const std::string& place) {
                     index(in(channel, "sampler"), in(animation, "samplers"), place + ".sampler");
                     index(in(channel, "target"), "node", "nodes", place + ".target");
                 });
        });
    }

    bool holds(const char* list, const std::string& name) {
        for (const Json& item : in(json_, list))
            if (item == name) return true;
        return false;
    }

    void checkExtensions() {
        for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
            std::set<Json> seen;
            section(list, [&](const Json& name, const std::string& where) {
                if (!name.is_string()) return fault(where, "is no name");
                if (!seen.insert(name).second) fault(where, "is there already");
                if (!holds("extensionsUsed", name.get<std::string>())) fault(where, "is not used");
            });
        }
        const Json& extensions = in(json_, "extensions");
        if (extensions.is_object())
            for (const auto& [name, value] : extensions.items())
                if (!holds("extensionsUsed", name)) fault("extensions." + name, "is not used");
        const std::string shadow = "EDGESHADE_shadow_volume";
        const Json& batches = in(in(extensions, shadow.c_str()), "batches");
        if (!batches.is_array()) return;
        for (std::size_t i = 0; i < batches.size(); ++i) {
            const std::string where = shadow + ".batches[" + std::to_string(i) + "]";
            index(batches[i], "node", "nodes", where);
            for (const char* key : {"simplifiedCasters", "sides", "caps", "edgeVertices",
                                    "oppositeCounts", "oppositeVertices"})
                index(batches[i], key, "accessors", where);
        }
    }

    const Json& json_;
    std::set<std::string> faults_;
};

std::uint32_t wordAt(const Bytes& bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8 | bytes.at(offset + i);
    return word;
}

} // namespace

std::set<std::string> structuralFaults(const Json& json) {
    return Structure(json).faults();
}

std::set<std::string> structuralFaults(const Bytes& glb) {
    const std::set<std::string> noGlb = {"file: is no GLB of a JSON chunk and a binary one"};
    if (glb.size() < 20 || glb.size() % 4 != 0 || std::memcmp(glb.data(), "glTF", 4) != 0 ||
        wordAt(glb, 4) != 2 || wordAt(glb, 8) != glb.size())
        return noGlb;
    const std::size_t jsonEnd = std::size_t{20} + wordAt(glb, 12);
    if (std::memcmp(&glb[16], "JSON", 4) != 0 || jsonEnd % 4 != 0 || jsonEnd > glb.size())
        return noGlb;
    std::size_t binarySize = 0;
    if (jsonEnd != glb.size()) {
        if (glb.size() - jsonEnd < 8 || std::memcmp(&glb[jsonEnd + 4], "BIN\0", 4) != 0)
            return noGlb;
        binarySize = wordAt(glb, jsonEnd);
        if (jsonEnd + 8 + binarySize != glb.size()) return noGlb;
    }
    const Json json =
        Json::parse(glb.begin() + 20, glb.begin() + static_cast<std::ptrdiff_t>(jsonEnd));
    std::set<std::string> faults = structuralFaults(json);
    const Json& buffers = in(json, "buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string where = "buffers[" + std::to_string(i) + "]";
        if (!in(buffers[i], "uri").is_null()) faults.insert(where + ": is elsewhere");
        const std::uint64_t length = numberIn(buffers[i], "byteLength");
        const Json& extensions = in(buffers[i], "extensions");
        const bool isFallback =
            !in(extensions, meshopt[0]).is_null() || !in(extensions, meshopt[1]).is_null();
        if (i == 0 ? length > binarySize || binarySize - length > 3 : !isFallback)
            faults.insert(where + ": is not the binary chunk");
    }
    if (buffers.empty() && binarySize != 0) faults.insert("file: has bytes of no buffer");
    return faults;
}

} // namespace edgeshade::test
