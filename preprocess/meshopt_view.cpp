#include "preprocess/meshopt_view.hpp"

#include "preprocess/gltf_document.hpp"
#include "preprocess/json_field.hpp"

#include <limits>
#include <meshoptimizer.h>
#include <string>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* extensionName = "EXT_meshopt_compression";
constexpr std::uint64_t largestDecodedView = std::uint64_t{1} << 31; // bytes

/// Bytes that one compressed byte can stand for. The vertex codec's least is two bits for sixteen
/// equal bytes, or for a block of 256 in its second version.
constexpr std::uint64_t largestExpansion = 1024;

/// The extension's fields (EXT_meshopt_compression, "Specifying compressed views").
struct CompressedView {
    std::span<const std::uint8_t> bytes;
    std::size_t stride;
    std::size_t count;
    std::string mode;
    std::string filter;
};

/// The field's value, where memory could hold that many.
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
        extension.fail(" ends past the end of buffer " + std::to_string(buffer));
    const auto filter = extension.find("filter");
    return {std::span(bytes).subspan(offset, length), sizeIn(extension.member("byteStride")),
            sizeIn(extension.member("count")), extension.member("mode").text(),
            filter ? filter->text() : "NONE"};
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
        extension.fail(".count is " + std::to_string(view.count) + ", no multiple of 3");
    const bool octahedral = view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8);
    const bool quaternion = view.filter == "QUATERNION" && view.stride == 8;
    const bool exponential = view.filter == "EXPONENTIAL" && view.stride % 4 == 0;
    if (view.filter != "NONE" && !(attributes && (octahedral || quaternion || exponential)))
        extension.fail(".filter is '" + view.filter + "' with byteStride " +
                       std::to_string(view.stride) + ", which is not allowed");
}

/// The count is checked against what is there before memory is set aside for it.
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
        extension.fail(count + ", which can't come from " + std::to_string(view.bytes.size()) +
                       " bytes");
}

void applyFilter(const CompressedView& view, Bytes& decoded) {
    if (view.filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
    else if (view.filter == "QUATERNION")
        meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
    else if (view.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
}

/// The bytes of the view, if it is compressed.
std::optional<Bytes> decodedView(GltfDocument& document, const JsonField& viewField) {
    const auto extensions = viewField.find("extensions");
    const auto extension = extensions ? extensions->find(extensionName) : std::nullopt;
    if (!extension) return std::nullopt;
    const CompressedView view = readFields(document, *extension);
    requireSupported(view, *extension);
    requirePlausible(view, viewField.member("byteLength").wholeNumber(), *extension);
    document.memory.take(view.count, view.stride,
                         document.where(extension->name()) + ".count is " +
                             std::to_string(view.count) + ", which");
    Bytes decoded(view.count * view.stride);
    if (!decodeMode(view, decoded)) extension->fail(" holds data that can't be decoded");
    applyFilter(view, decoded);
    return decoded;
}

} // namespace

bool isMeshoptFallback(const Json& buffer) {
    const auto extensions = buffer.find("extensions");
    return extensions != buffer.end() && extensions->is_object() &&
           extensions->contains(extensionName);
}

void decodeMeshoptViews(GltfDocument& document) {
    const JsonField root(document.path, document.json);
    std::size_t index = 0;
    root.ifPresent("bufferViews", [&](const JsonField& views) {
        views.forEachItem([&](const JsonField& view) {
            document.decodedViews[index++] = decodedView(document, view);
        });
    });
}

} // namespace edgeshade
