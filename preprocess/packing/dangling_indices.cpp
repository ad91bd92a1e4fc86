#include "preprocess/packing/dangling_indices.hpp"

#include <cstdint>
#include <span>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

std::size_t countOf(const Json& json, const char* section) {
    const auto items = json.find(section);
    return items == json.end() ? 0 : items->size();
}

/// The member's items; empty if it is no array.
std::span<Json> itemsOf(Json& object, const char* key) {
    if (!object.is_object() || !object.contains(key) || !object[key].is_array()) return {};
    return object[key].get_ref<Json::array_t&>();
}

bool eraseIfDangling(Json& object, const char* key, std::size_t count) {
    if (!object.is_object() || !object.contains(key)) return false;
    const Json& index = object[key];
    // Numbers set from code may be of a signed type without being negative.
    const bool isWhole =
        index.is_number_unsigned() || (index.is_number_integer() && index.get<std::int64_t>() >= 0);
    if (!isWhole || index.get<std::uint64_t>() < count) return false;
    object.erase(key);
    return true;
}

} // namespace

bool eraseDanglingIndices(Json& json) {
    bool any = false;
    for (Json& image : itemsOf(json, "images"))
        if (eraseIfDangling(image, "bufferView", countOf(json, "bufferViews"))) {
            image.erase("uri"); // unread so far, but it would be read now
            any = true;
        }
    for (Json& animation : itemsOf(json, "animations"))
        for (Json& sampler : itemsOf(animation, "samplers"))
            for (const char* key : {"input", "output"})
                any |= eraseIfDangling(sampler, key, countOf(json, "accessors"));
    return any;
}

} // namespace edgeshade
