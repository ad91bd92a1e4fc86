#include "preprocess/base/error.hpp"
#include "preprocess/gltf/gltf_checks.hpp"
#include "preprocess/packing/dangling_indices.hpp"
#include "preprocess/packing/shadow_extension.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void failRearranged(const std::filesystem::path& path) {
    throw InputError("'" + path.string() +
                     "' was rearranged after it was packed: pack the original instead.");
}

bool isInBuffer0(const Json& range) {
    return range.value("buffer", std::size_t{0}) == 0;
}

std::size_t endOf(const Json& range) {
    return range.value("byteOffset", std::size_t{0}) + range.value("byteLength", std::size_t{0});
}

/// The end of the last byte of buffer 0 that a view uses, directly or compressed.
std::size_t usedEnd(const Json& json) {
    std::size_t end = 0;
    if (!json.contains("bufferViews")) return end;
    for (const Json& view : json["bufferViews"]) {
        if (isInBuffer0(view)) end = std::max(end, endOf(view));
        if (!view.contains("extensions")) continue;
        for (const Json& extension : view["extensions"])
            if (extension.contains("buffer") && isInBuffer0(extension))
                end = std::max(end, endOf(extension));
    }
    return end;
}

/// Removes the last accessor and the last view, which must belong together. Returns the view.
Json removeLastArray(Json& json, int accessor, const std::filesystem::path& path) {
    if (!json.contains("accessors") || !json.contains("bufferViews")) failRearranged(path);
    Json& accessors = json["accessors"];
    Json& views = json["bufferViews"];
    const bool isLast = static_cast<std::size_t>(accessor) + 1 == accessors.size() &&
                        accessors.back().value("bufferView", views.size()) + 1 == views.size();
    if (!isLast || !isInBuffer0(views.back())) failRearranged(path);
    Json view = std::move(views.back());
    accessors.erase(accessors.size() - 1);
    views.erase(views.size() - 1);
    return view;
}

void removeData(Json& json, Bytes& binary, const std::set<int>& accessors,
                const std::filesystem::path& path) {
    std::size_t shadowStart = binary.size();
    for (auto accessor = accessors.rbegin(); accessor != accessors.rend(); ++accessor) {
        const Json view = removeLastArray(json, *accessor, path);
        shadowStart = std::min(shadowStart, view.value("byteOffset", std::size_t{0}));
    }
    // Bytes that a tool moved behind the shadow data would be cut off with them.
    if (usedEnd(json) > shadowStart) failRearranged(path);
    binary.resize(shadowStart);
    // Any other reference to them would refer to whatever is added next.
    if (eraseDanglingIndices(json)) failRearranged(path);
    try {
        Warnings ignored;
        requireSoundGltf(json, path, ignored);
    } catch (const InputError&) {
        failRearranged(path);
    }
}

void removeName(Json& json) {
    if (json.contains("extensions")) json["extensions"].erase(shadowExtensionName);
    if (!json.contains("extensionsUsed")) return;
    Json& used = json["extensionsUsed"];
    used.erase(std::remove(used.begin(), used.end(), shadowExtensionName), used.end());
}

} // namespace

void removeShadowExtension(Json& json, Bytes& binary, const std::filesystem::path& path) {
    if (const Json* extension = shadowExtensionOf(json))
        removeData(json, binary, shadowAccessorsOf(*extension), path);
    removeName(json);
}

} // namespace edgeshade
