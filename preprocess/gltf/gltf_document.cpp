#include "preprocess/gltf/gltf_document.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/data_uri.hpp"
#include "preprocess/gltf/json_field.hpp"
#include "preprocess/gltf/percent_encoding.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

#include <algorithm>
#include <string_view>

namespace edgeshade {
namespace {

/// The path of a decoded uri, with "." and ".." resolved. A backslash separates names too:
/// exporters on Windows write it, and no real name contains one.
std::filesystem::path placeOf(std::string decoded) {
    std::replace(decoded.begin(), decoded.end(), '\\', '/');
    return std::filesystem::path(decoded).lexically_normal();
}

/// Whether the path stays within the folder it is relative to.
bool isInside(const std::filesystem::path& place) {
    return !place.empty() && place.is_relative() && *place.begin() != "..";
}

/// Whether a colon ends the first name of a decoded uri, as after a scheme or a drive.
bool hasScheme(const std::string& decoded) {
    const std::size_t end = decoded.find_first_of("/\\:");
    return end != std::string::npos && decoded[end] == ':';
}

/// The path of `uri`, with links followed. Throws unless it is inside the asset's folder.
std::filesystem::path pathOfUri(const GltfDocument& document, const std::string& field,
                                const std::string& uri) {
    const std::string said = document.where(field) + " is '" + uri.substr(0, 80) + "', but ";
    const std::string decoded = percentDecoded(uri);
    const std::filesystem::path place = placeOf(decoded);
    if (hasScheme(decoded) || !isInside(place))
        throw InputError(said + "only files in the asset's own folder and data URIs are read.");
    if (decoded.find_first_of(std::string_view(":\0", 2)) != std::string::npos)
        throw InputError(said + "a name with a colon or a zero byte is not read, because some "
                                "systems give it another meaning.");
    const std::filesystem::path path = document.path.parent_path() / place;
    std::error_code missing;
    const auto file = std::filesystem::canonical(path, missing);
    if (missing) return path; // reading it reports the error
    const auto folder = std::filesystem::canonical(
        path.parent_path().empty() ? std::filesystem::path(".") : document.path.parent_path() / ".",
        missing);
    if (missing || *file.lexically_relative(folder).begin() == "..")
        throw InputError(said + "that is a link out of the asset's own folder.");
    if (!std::filesystem::is_directory(file) && !std::filesystem::is_regular_file(file))
        throw InputError(said + "that is not a regular file.");
    return file;
}

} // namespace

Bytes resolveUri(const GltfDocument& document, const std::string& field, const std::string& uri) {
    if (isDataUri(uri)) return dataOfUri(uri, document.where(field));
    const std::filesystem::path file = pathOfUri(document, field, uri);
    try {
        return readFile(file, document.memory.limits().fileBytes);
    } catch (const LimitError& error) {
        throw LimitError(document.where(field) + ": " + error.what());
    } catch (const InputError& error) {
        throw InputError(document.where(field) + ": " + error.what());
    }
}

std::span<const std::uint8_t> bufferViewBytes(const GltfDocument& document, int view) {
    const auto& views = document.model->bufferViews;
    if (view < 0 || static_cast<std::size_t>(view) >= views.size())
        throw InputError(document.where("bufferView ") + std::to_string(view) +
                         " does not exist; there are " + std::to_string(views.size()) + ".");
    if (document.decodedViews[view]) return *document.decodedViews[view];
    const tinygltf::BufferView& range = views[view];
    if (range.buffer < 0 || static_cast<std::size_t>(range.buffer) >= document.buffers.size())
        throw InputError(document.where("bufferViews[") + std::to_string(view) + "].buffer is " +
                         std::to_string(range.buffer) + ", which does not exist.");
    const Bytes& bytes = document.buffers[range.buffer];
    if (range.byteOffset > bytes.size() || range.byteLength > bytes.size() - range.byteOffset)
        throw InputError(document.where("bufferViews[") + std::to_string(view) + "] ends at byte " +
                         std::to_string(range.byteOffset + range.byteLength) + ", but buffer " +
                         std::to_string(range.buffer) + " has " + std::to_string(bytes.size()) +
                         ".");
    return std::span(bytes).subspan(range.byteOffset, range.byteLength);
}

Bytes encodedImageBytes(const GltfDocument& document, int image) {
    const JsonField root(document.path, document.json);
    const auto images = root.find("images");
    if (!images || image < 0 || static_cast<std::size_t>(image) >= images->size())
        throw InputError(document.where("images[") + std::to_string(image) + "] does not exist.");
    const JsonField source = images->item(static_cast<std::size_t>(image));
    if (const auto view = source.find("bufferView")) {
        const auto bytes = bufferViewBytes(
            document, view->indexInto(document.model->bufferViews.size(), "bufferViews"));
        return Bytes(bytes.begin(), bytes.end());
    }
    if (const auto uri = source.find("uri")) return resolveUri(document, uri->name(), uri->text());
    source.fail(" has neither a bufferView nor a uri");
}

} // namespace edgeshade
