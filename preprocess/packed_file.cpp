#include "preprocess/packed_file.hpp"

#include "preprocess/error.hpp"
#include "preprocess/glb.hpp"
#include "preprocess/image_type.hpp"
#include "preprocess/json_field.hpp"

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// Where a source buffer ended up.
struct BufferPlace {
    std::size_t buffer;
    std::size_t offset;
};

void alignTo4(Bytes& bytes) {
    bytes.resize((bytes.size() + 3) / 4 * 4, 0);
}

void moveReference(Json& reference, const std::vector<BufferPlace>& places) {
    const BufferPlace& place = places.at(reference.at("buffer").get<std::size_t>());
    reference["buffer"] = place.buffer;
    const auto offset = reference.value("byteOffset", std::size_t{0}) + place.offset;
    if (offset != 0 || reference.contains("byteOffset")) reference["byteOffset"] = offset;
}

/// What the joined buffer keeps of the first one that is in it.
Json joinedBuffer(const Json& first) {
    Json joined = Json::object();
    for (const char* key : {"name", "extras"})
        if (first.contains(key)) joined[key] = first[key];
    return joined;
}

/// Joins all buffers that have bytes into one; buffers without (meshopt fallbacks) follow it. It
/// ends at a multiple of four, where shadow data will begin, so that packing it again joins the
/// same bytes.
Bytes joinBuffers(const GltfDocument& document, Json& json) {
    Bytes binary;
    if (!json.contains("buffers")) return binary;
    Json buffers = Json::array({Json::object()});
    std::vector<BufferPlace> places;
    for (std::size_t i = 0; i < document.buffers.size(); ++i) {
        const bool hasBytes =
            !document.buffers[i].empty() || !json["buffers"][i].contains("extensions");
        if (hasBytes) {
            if (binary.empty()) buffers[0] = joinedBuffer(json["buffers"][i]);
            places.push_back({0, binary.size()});
            binary.insert(binary.end(), document.buffers[i].begin(), document.buffers[i].end());
            alignTo4(binary);
        } else {
            places.push_back({buffers.size(), 0});
            buffers.push_back(json["buffers"][i]);
        }
    }
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

/// Moves image `i` from its uri into a view of its own. Throws InputError, before anything is
/// changed, where that can't be done.
void embedImage(const GltfDocument& document, std::size_t i, Json& json, Bytes& binary) {
    const Bytes bytes = encodedImageBytes(document, static_cast<int>(i));
    const std::string_view type = imageTypeOf(bytes);
    if (type.empty()) // which a view must say
        throw InputError(document.where("images[") + std::to_string(i) +
                         "] is neither PNG, JPEG, WebP nor KTX2.");
    if (!json.contains("buffers")) json["buffers"] = Json::array({Json::object()});
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    alignTo4(binary);
    Json& image = json["images"][i]; // only now: a new member moves all others of its object
    image.erase("uri");
    image["bufferView"] = json["bufferViews"].size() - 1;
    image["mimeType"] = type;
}

/// What can't be embedded stays as it is.
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

Bytes packedChecked(const GltfDocument& document, const Scene& scene,
                    const std::vector<BatchTopology>& topology, Encoding encoding,
                    const CasterSettings& settings, Warnings& warnings) {
    Json json = document.json;
    Bytes binary = joinBuffers(document, json);
    if (readShadowHeader(document)) removeShadowExtension(json, binary, document.path);
    embedImages(document, json, binary, warnings);
    appendShadowExtension(json, binary, scene, topology, encoding, settings);
    if (binary.empty())
        json.erase("buffers");
    else
        json["buffers"][0]["byteLength"] = binary.size();
    return joinGlb(json.dump(), std::move(binary));
}

} // namespace

Bytes packedGlb(const GltfDocument& document, const Scene& scene,
                const std::vector<BatchTopology>& topology, Encoding encoding,
                const CasterSettings& settings, Warnings& warnings) {
    return withJsonErrors(document.path, [&] {
        return packedChecked(document, scene, topology, encoding, settings, warnings);
    });
}

} // namespace edgeshade
