#include "preprocess/meshopt_view.hpp"

#include "preprocess/error.hpp"
#include "preprocess/gltf_document.hpp"

#include <meshoptimizer.h>
#include <string>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* extensionName = "EXT_meshopt_compression";
constexpr std::uint64_t largestDecodedView = std::uint64_t{1} << 31; // bytes

/// The extension's fields (EXT_meshopt_compression, "Specifying compressed views").
struct CompressedView {
    std::span<const std::uint8_t> bytes;
    std::size_t stride;
    std::size_t count;
    std::string mode;
    std::string filter;
};

CompressedView readFields(const GltfDocument& document, const Json& extension,
                          const std::string& field) {
    const auto buffer = extension.at("buffer").get<std::size_t>();
    const auto offset = extension.value("byteOffset", std::uint64_t{0});
    const auto length = extension.at("byteLength").get<std::uint64_t>();
    if (buffer >= document.buffers.size())
        throw InputError(field + ".buffer is " + std::to_string(buffer) +
                         ", which does not exist.");
    const Bytes& bytes = document.buffers[buffer];
    if (offset > bytes.size() || length > bytes.size() - offset)
        throw InputError(field + " ends past the end of buffer " + std::to_string(buffer) + ".");
    return {std::span(bytes).subspan(offset, length), extension.at("byteStride").get<std::size_t>(),
            extension.at("count").get<std::size_t>(), extension.at("mode").get<std::string>(),
            extension.value("filter", std::string("NONE"))};
}

/// Decodes into `decoded`, which has count * stride bytes; returns whether the data was sound.
bool decodeMode(const CompressedView& view, Bytes& decoded) {
    if (view.mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(decoded.data(), view.count, view.stride,
                                          view.bytes.data(), view.bytes.size()) == 0;
    if (view.mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(decoded.data(), view.count, view.stride, view.bytes.data(),
                                         view.bytes.size()) == 0;
    return meshopt_decodeIndexSequence(decoded.data(), view.count, view.stride, view.bytes.data(),
                                       view.bytes.size()) == 0;
}

void requireSupported(const CompressedView& view, const std::string& field) {
    const bool attributes = view.mode == "ATTRIBUTES";
    if (!attributes && view.mode != "TRIANGLES" && view.mode != "INDICES")
        throw InputError(field + ".mode is '" + view.mode + "', which is not known.");
    const bool strideFits = attributes
                                ? view.stride > 0 && view.stride <= 256 && view.stride % 4 == 0
                                : view.stride == 2 || view.stride == 4;
    if (!strideFits)
        throw InputError(field + ".byteStride is " + std::to_string(view.stride) + ", which mode " +
                         view.mode + " does not allow.");
    if (view.mode == "TRIANGLES" && view.count % 3 != 0)
        throw InputError(field + ".count is " + std::to_string(view.count) + ", no multiple of 3.");
    if (view.count > largestDecodedView / view.stride)
        throw InputError(field + ".count is " + std::to_string(view.count) +
                         ", which is too many.");
    const bool octahedral = view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8);
    const bool quaternion = view.filter == "QUATERNION" && view.stride == 8;
    const bool exponential = view.filter == "EXPONENTIAL" && view.stride % 4 == 0;
    if (view.filter != "NONE" && !(attributes && (octahedral || quaternion || exponential)))
        throw InputError(field + ".filter is '" + view.filter + "' with byteStride " +
                         std::to_string(view.stride) + ", which is not allowed.");
}

void applyFilter(const CompressedView& view, Bytes& decoded) {
    if (view.filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
    else if (view.filter == "QUATERNION")
        meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
    else if (view.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
}

} // namespace

bool isMeshoptFallback(const Json& buffer) {
    const auto extensions = buffer.find("extensions");
    return extensions != buffer.end() && extensions->is_object() &&
           extensions->contains(extensionName);
}

void decodeMeshoptViews(GltfDocument& document) {
    if (!document.json.contains("bufferViews")) return;
    const Json& views = document.json["bufferViews"];
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i].contains("extensions") || !views[i]["extensions"].contains(extensionName))
            continue;
        const std::string field =
            document.where("bufferViews[") + std::to_string(i) + "]." + extensionName;
        const CompressedView view =
            readFields(document, views[i]["extensions"][extensionName], field);
        requireSupported(view, field);
        Bytes decoded(view.count * view.stride);
        if (!decodeMode(view, decoded))
            throw InputError(field + " holds data that can't be decoded.");
        applyFilter(view, decoded);
        document.decodedViews[i] = std::move(decoded);
    }
}

} // namespace edgeshade
