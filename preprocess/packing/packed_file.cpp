#include "preprocess/packing/packed_file.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/buffer_view.hpp"
#include "preprocess/gltf/glb.hpp"
#include "preprocess/gltf/image_type.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/gltf/meshopt_view.hpp"
#include "preprocess/packing/dangling_indices.hpp"

#include <algorithm>
#include <set>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// The new place of a source buffer.
struct BufferPlace {
    std::size_t buffer;
    std::size_t offset;
};

void moveReference(Json& reference, const std::vector<BufferPlace>& places) {
    const BufferPlace& place = places.at(reference.at("buffer").get<std::size_t>());
    reference["buffer"] = place.buffer;
    const auto offset = reference.value("byteOffset", std::size_t{0}) + place.offset;
    if (offset != 0 || reference.contains("byteOffset")) reference["byteOffset"] = offset;
}

/// The members that the joined buffer keeps of its first source.
Json joinedBuffer(const Json& first) {
    Json joined = Json::object();
    for (const char* key : {"name", "extras"})
        if (first.contains(key)) joined[key] = first[key];
    return joined;
}

/// A buffer without bytes, with its uri removed.
Json fallbackBuffer(Json buffer) {
    buffer.erase("uri");
    return buffer;
}

/// Cuts views off at their buffer's end. Bytes beyond it can't be read, and would be another
/// buffer's once buffers are joined. A view wholly beyond the end begins in the buffer's last word,
/// with its alignment kept. Throws InputError for a compressed view, whose length matters.
void cutViews(const GltfDocument& document, Json& json) {
    for (std::size_t i = 0; i < document.decodedViews.size(); ++i) {
        Json& view = json["bufferViews"][i];
        const Json& buffer = json["buffers"][view["buffer"].get<std::size_t>()];
        const auto end = buffer["byteLength"].get<std::uint64_t>();
        const auto length = view["byteLength"].get<std::uint64_t>();
        auto offset = view.value("byteOffset", std::uint64_t{0});
        if (offset <= end && length <= end - offset) continue;
        if (offset > end) offset = end - end % 4;
        if (document.decodedViews[i])
            throw InputError(document.where("bufferViews[") + std::to_string(i) +
                             "] ends past buffer " + view["buffer"].dump() + ", which has " +
                             std::to_string(end) + " bytes.");
        view["byteOffset"] = offset;
        view["byteLength"] = std::min(length, end - offset);
    }
}

/// Joins all buffers with bytes into one, which exists even if empty. Buffers without bytes
/// (meshopt fallbacks) follow it. It ends at a multiple of four, where shadow data will begin, so
/// that packing the file again joins the same bytes.
Bytes joinBuffers(const GltfDocument& document, Json& json) {
    Bytes binary;
    Json buffers = Json::array({Json::object()});
    std::vector<BufferPlace> places;
    for (std::size_t i = 0; i < document.buffers.size(); ++i) {
        const Json& source = json["buffers"][i];
        if (!document.buffers[i].empty() || !isMeshoptFallback(source)) {
            if (binary.empty()) buffers[0] = joinedBuffer(source);
            places.push_back({0, binary.size()});
            binary.insert(binary.end(), document.buffers[i].begin(), document.buffers[i].end());
            alignTo4(binary);
        } else {
            places.push_back({buffers.size(), 0});
            buffers.push_back(fallbackBuffer(source));
        }
    }
    buffers[0]["byteLength"] = binary.size();
    json["buffers"] = std::move(buffers);
    if (json.contains("bufferViews"))
        for (Json& view : json["bufferViews"]) {
            moveReference(view, places);
            if (view.contains("extensions"))
                for (Json& extension : view["extensions"])
                    if (extension.contains("buffer")) moveReference(extension, places);
        }
    return binary;
}

/// Moves image `i` from its uri into a view. Throws InputError, before any change, if that fails.
void embedImage(const GltfDocument& document, std::size_t i, Json& json, Bytes& binary) {
    const Bytes bytes = encodedImageBytes(document, static_cast<int>(i));
    const std::string_view type = imageTypeOf(bytes);
    if (type.empty()) // a view must state its type
        throw InputError(document.where("images[") + std::to_string(i) +
                         "] is neither PNG, JPEG, WebP nor KTX2.");
    const std::size_t view = appendView(json, binary, bytes);
    Json& image = json["images"][i]; // looked up only now, as the first view moves it
    image.erase("uri");
    image["bufferView"] = view;
    image["mimeType"] = type;
}

/// Images that can't be embedded stay as they are.
void embedImages(const GltfDocument& document, Json& json, Bytes& binary, Warnings& warnings) {
    if (!json.contains("images")) return;
    for (std::size_t i = 0; i < json["images"].size(); ++i) {
        if (!json["images"][i].contains("uri")) continue;
        try {
            embedImage(document, i, json, binary);
        } catch (const LimitError&) {
            throw;
        } catch (const InputError& error) {
            warnings.add(clauseOf(error.what()) + "; it is not embedded.");
        }
    }
}

/// Removes empty sections, which glTF forbids. They come from the file, or from removed shadow
/// data.
void removeEmptySections(Json& json) {
    for (const char* section : {"accessors", "animations", "bufferViews", "cameras", "extensions",
                                "extensionsRequired", "extensionsUsed", "images", "materials",
                                "meshes", "nodes", "samplers", "scenes", "skins", "textures"})
        if (json.contains(section) && json[section].empty()) json.erase(section);
}

/// Removes repeated extension names, which glTF forbids. The first one stays.
void removeRepeatedNames(Json& json) {
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        if (!json.contains(list) || !json[list].is_array()) continue;
        Json once = Json::array();
        std::set<std::string> seen;
        for (const Json& name : json[list])
            if (seen.insert(name.dump()).second) once.push_back(name);
        json[list] = std::move(once);
    }
}

Bytes packedChecked(const GltfDocument& document, const Scene& scene, const Topologies& topology,
                    Encoding encoding, const CasterSettings& settings, Warnings& warnings) {
    Json json = document.json;
    eraseDanglingIndices(json);
    cutViews(document, json);
    Bytes binary = joinBuffers(document, json);
    readShadowHeader(document); // refuses an unsound extension
    removeShadowExtension(json, binary, document.path);
    removeRepeatedNames(json);
    removeEmptySections(json);
    embedImages(document, json, binary, warnings);
    alignTo4(binary); // as joinBuffers() does when the file is packed again
    appendShadowExtension(json, binary, scene, topology, encoding, settings);
    // Views of buffers without bytes still need a buffer.
    if (binary.empty() && json.contains("bufferViews")) binary.resize(4);
    if (binary.empty())
        json.erase("buffers");
    else
        json["buffers"][0]["byteLength"] = binary.size();
    return joinGlb(json.dump(), std::move(binary));
}

} // namespace

Bytes packedGlb(const GltfDocument& document, const Scene& scene, const Topologies& topology,
                Encoding encoding, const CasterSettings& settings, Warnings& warnings) {
    return withJsonErrors(document.path, [&] {
        return packedChecked(document, scene, topology, encoding, settings, warnings);
    });
}

} // namespace edgeshade
