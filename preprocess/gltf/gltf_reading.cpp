#include "preprocess/gltf/gltf_reading.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/animation_checks.hpp"
#include "preprocess/gltf/glb.hpp"
#include "preprocess/gltf/gltf_checks.hpp"
#include "preprocess/gltf/gltf_mending.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/gltf/meshopt_view.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

void resolveBuffers(GltfDocument& document, std::optional<Bytes> binary) {
    if (!document.json.contains("buffers")) return;
    const Json& buffers = document.json["buffers"];
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string field = "buffers[" + std::to_string(i) + "]";
        const Json& buffer = buffers[i];
        const auto length = buffer["byteLength"].get<std::uint64_t>();
        Bytes bytes;
        if (buffer.contains("uri"))
            bytes = resolveUri(document, field + ".uri", buffer["uri"].get<std::string>());
        else if (i == 0 && binary)
            bytes = std::move(*binary);
        else if (!isMeshoptFallback(buffer))
            throw InputError(document.where(field) + ".uri is missing.");
        else {
            document.buffers.emplace_back();
            continue;
        }
        if (bytes.size() < length)
            throw InputError(document.where(field) + ".byteLength is " + std::to_string(length) +
                             ", but there are " + std::to_string(bytes.size()) + " bytes.");
        document.memory.take(bytes.size(), 1, document.where(field));
        bytes.resize(static_cast<std::size_t>(length));
        document.buffers.push_back(std::move(bytes));
    }
}

GltfDocument parseChecked(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                          const ReadingLimits& limits) {
    GltfDocument document;
    document.path = path;
    document.memory = MemoryBudget(limits);
    if (bytes.empty()) throw InputError("'" + path.string() + "' is empty.");
    const bool inGlb = isGlb(bytes);
    GlbChunks chunks;
    if (inGlb)
        chunks = splitGlb(bytes, path);
    else
        chunks.json.assign(bytes.begin(), bytes.end());
    document.json = parseJson(chunks.json, path, inGlb, document.memory, document.warnings);
    mendGltf(document.json, path, document.warnings);
    requireSoundGltf(document.json, path, document.warnings);
    tagMeshoptFallbacks(document.json);
    requireWithinLimits(document.json, path, document.memory);
    document.model = std::make_shared<const tinygltf::Model>(typedModel(
        document.json, findBrokenAnimations(document.json, path, document.warnings), path));
    resolveBuffers(document, std::move(chunks.binary));
    document.decodedViews.resize(document.model->bufferViews.size());
    decodeMeshoptViews(document);
    return document;
}

} // namespace

GltfDocument readGltf(const std::filesystem::path& path, const ReadingLimits& limits) {
    return parseGltf(readFile(path, limits.fileBytes), path, limits);
}

GltfDocument parseGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                       const ReadingLimits& limits) {
    return withJsonErrors(path, [&] { return parseChecked(bytes, path, limits); });
}

} // namespace edgeshade
