#include "preprocess/gltf/meshopt_view.hpp"

#include "preprocess/gltf/color_filter.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/gltf/json_field.hpp"

#include <limits>
#include <meshoptimizer.h>
#include <string>
#include <string_view>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// The second has a newer vertex codec and one more filter than the first.
constexpr const char* extensionNames[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr bool isKhronos(std::string_view name) {
    return name == extensionNames[1];
}
constexpr std::uint64_t largestDecodedView = std::uint64_t{1} << 31; // bytes

/// The most bytes that one compressed byte can expand to. The vertex codec's minimum is two bits
/// for sixteen equal bytes, or in its second version for a block of 256.
constexpr std::uint64_t largestExpansion = 1024;

/// The extension's fields (EXT_meshopt_compression, "Specifying compressed views").
struct CompressedView {
    std::span<const std::uint8_t> bytes;
    std::size_t stride;
    std::size_t count;
    std::string mode;
    std::string filter;
};

/// The field's value, which must fit a std::size_t.
std::size_t sizeIn(const JsonField& field) {
    const std::uint64_t value = field.wholeNumber();
    if (value > std::numeric_limits<std::size_t>::max())
        field.fail(" is " + std::to_string(value) + ", which is too many");
    return static_cast<std::size_t>(value);
}

CompressedView readFields(const GltfDocument& document, const JsonField& extension) {
    const auto buffer = extension.member("buffer").indexInto(document.buffers.size(), "buffers");
    const auto offsetField = extension.find("byteOffset");
    const std::size_t offset = offsetField ? sizeIn(*offsetField) : 0;
    const std::size_t length = sizeIn(extension.member("byteLength"));
    const Bytes& bytes = document.buffers[buffer];
    if (offset > bytes.size() || length > bytes.size() - offset)
        extension.fail(" extends past the end of buffer " + std::to_string(buffer));
    const auto filter = extension.find("filter");
    return {std::span(bytes).subspan(offset, length), sizeIn(extension.member("byteStride")),
            sizeIn(extension.member("count")), extension.member("mode").text(),
            filter ? filter->text() : "NONE"};
}

/// Decodes into `decoded`, which has count * stride bytes; returns whether the data was valid.
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

void requireSupported(const CompressedView& view, const JsonField& extension) {
    const bool attributes = view.mode == "ATTRIBUTES";
    if (!attributes && view.mode != "TRIANGLES" && view.mode != "INDICES")
        extension.fail(".mode is '" + view.mode + "', which is not known");
    const bool strideFits = attributes
                                ? view.stride > 0 && view.stride <= 256 && view.stride % 4 == 0
                                : view.stride == 2 || view.stride == 4;
    if (!strideFits)
        extension.fail(".byteStride is " + std::to_string(view.stride) + ", which mode " +
                       view.mode + " does not allow");
    if (view.mode == "TRIANGLES" && view.count % 3 != 0)
        extension.fail(".count is " + std::to_string(view.count) +
                       ", which is not a multiple of 3");
    const bool octahedral = view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8);
    const bool quaternion = view.filter == "QUATERNION" && view.stride == 8;
    const bool exponential = view.filter == "EXPONENTIAL" && view.stride % 4 == 0;
    const bool color = view.filter == "COLOR" && (view.stride == 4 || view.stride == 8) &&
                       isKhronos(extension.key());
    if (view.filter != "NONE" &&
        !(attributes && (octahedral || quaternion || exponential || color)))
        extension.fail(".filter is '" + view.filter + "' with byteStride " +
                       std::to_string(view.stride) + ", which is not allowed");
}

/// The upper four bits of a stream's first byte are its codec, the lower four its version.
void requireKnownVersion(const CompressedView& view, const JsonField& extension) {
    constexpr int vertexCodec = 0xA0;
    const int version = view.bytes.empty() ? 0 : view.bytes[0] - vertexCodec;
    if (view.mode == "ATTRIBUTES" && version > 0 && version < 16)
        extension.fail(" holds vertices of codec version " + std::to_string(version) +
                       ", but this program decodes only version 0");
}

/// Checks the count against the available data before allocating memory for it.
void requirePlausible(const CompressedView& view, std::uint64_t viewLength,
                      const JsonField& extension) {
    const std::string count = ".count is " + std::to_string(view.count);
    if (view.count > largestDecodedView / view.stride)
        extension.fail(count + ", which is too many");
    const std::uint64_t decoded = std::uint64_t{view.count} * view.stride;
    if (decoded != viewLength)
        extension.fail(count + " with byteStride " + std::to_string(view.stride) +
                       ", but the view has " + std::to_string(viewLength) + " bytes");
    if (decoded / largestExpansion > view.bytes.size())
        extension.fail(count + ", which is too many for " + std::to_string(view.bytes.size()) +
                       " bytes");
}

void applyFilter(const CompressedView& view, Bytes& decoded) {
    if (view.filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
    else if (view.filter == "QUATERNION")
        meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
    else if (view.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
    else if (view.filter == "COLOR")
        decodeColorFilter(decoded, view.stride);
}

Bytes decodedView(GltfDocument& document, const JsonField& viewField, const JsonField& extension) {
    const CompressedView view = readFields(document, extension);
    requireSupported(view, extension);
    requirePlausible(view, viewField.member("byteLength").wholeNumber(), extension);
    requireKnownVersion(view, extension);
    document.memory.take(view.count, view.stride,
                         document.where(extension.name()) + ".count is " +
                             std::to_string(view.count) + ", which");
    Bytes decoded(view.count * view.stride);
    if (!decodeMode(view, decoded)) extension.fail(" holds data that can't be decoded");
    applyFilter(view, decoded);
    return decoded;
}

/// The extension of a buffer or a view, by either name, or null.
const Json* extensionOf(const Json& object) {
    const auto extensions = object.find("extensions");
    if (extensions == object.end() || !extensions->is_object()) return nullptr;
    for (const char* name : extensionNames)
        if (const auto extension = extensions->find(name); extension != extensions->end())
            return &*extension;
    return nullptr;
}

} // namespace

bool isMeshoptFallback(const Json& buffer) {
    return extensionOf(buffer) != nullptr;
}

void tagMeshoptFallbacks(Json& json) {
    if (!json.contains("buffers") || !json.contains("bufferViews")) return;
    Json& buffers = json["buffers"];
    std::vector<const char*> compressedBy(buffers.size(), nullptr);
    std::vector<bool> needed(buffers.size(), false);
    for (const Json& view : json["bufferViews"]) {
        const auto buffer = view["buffer"].get<std::size_t>();
        const Json* extension = extensionOf(view);
        if (!extension) {
            needed[buffer] = true;
            continue;
        }
        compressedBy[buffer] =
            view["extensions"].contains(extensionNames[0]) ? extensionNames[0] : extensionNames[1];
        const auto source = extension->find("buffer");
        if (source != extension->end() && source->is_number_integer())
            needed[source->get<std::size_t>()] = true;
    }
    for (std::size_t i = 0; i < buffers.size(); ++i)
        if (!needed[i] && compressedBy[i] && !buffers[i].contains("uri") &&
            !isMeshoptFallback(buffers[i]))
            buffers[i]["extensions"][compressedBy[i]]["fallback"] = true;
}

void decodeMeshoptViews(GltfDocument& document) {
    const JsonField root(document.path, document.json);
    std::size_t index = 0;
    root.ifPresent("bufferViews", [&](const JsonField& views) {
        views.forEachItem([&](const JsonField& view) {
            std::optional<Bytes>& decoded = document.decodedViews[index++];
            for (const char* name : extensionNames)
                view.ifExtension(name, [&](const JsonField& extension) {
                    decoded = decodedView(document, view, extension);
                });
        });
    });
}

} // namespace edgeshade
