// EDGESHADE_shadow_volume: changes the extension's JSON, the accessors and views that it names, and
// their bytes; the geometry, and with it the hash, stays as packed.
#include "preprocess/packing/shadow_extension.hpp"
#include "tests/fuzz/glb_mutation.hpp"

using namespace edgeshade::test;

namespace {

Json* extensionOf(Json& json) {
    if (!json.is_object() || !json.contains("extensions")) return nullptr;
    Json& extensions = json["extensions"];
    const bool there =
        extensions.is_object() && extensions.contains(edgeshade::shadowExtensionName);
    return there ? &extensions[edgeshade::shadowExtensionName] : nullptr;
}

/// The item of the section at `index`; null if there is none.
Json* itemOf(Json& json, const char* section, const Json& index) {
    const bool there = json.contains(section) && json[section].is_array() &&
                       index.is_number_unsigned() &&
                       index.get<std::size_t>() < json[section].size();
    return there ? &json[section][index.get<std::size_t>()] : nullptr;
}

/// The accessors that batches name.
std::vector<Json*> accessorsOf(Json& json) {
    std::vector<Json*> accessors;
    const Json* extension = extensionOf(json);
    if (!extension || !extension->is_object() || !extension->contains("batches")) return accessors;
    for (const Json& batch : (*extension)["batches"])
        if (batch.is_object())
            for (const char* key : {"simplifiedCasters", "sides", "caps", "edgeVertices",
                                    "oppositeCounts", "oppositeVertices"})
                if (batch.contains(key))
                    if (Json* accessor = itemOf(json, "accessors", batch[key]))
                        accessors.push_back(accessor);
    return accessors;
}

std::vector<Json*> viewsOf(Json& json) {
    std::vector<Json*> views;
    for (Json* accessor : accessorsOf(json))
        if (accessor->is_object() && accessor->contains("bufferView"))
            if (Json* view = itemOf(json, "bufferViews", (*accessor)["bufferView"]))
                views.push_back(view);
    return views;
}

std::vector<Json*> extensionAndAccessors(Json& json) {
    std::vector<Json*> roots = accessorsOf(json);
    if (Json* extension = extensionOf(json)) roots.insert(roots.end(), 3, extension);
    return roots;
}

} // namespace

MutationScope edgeshade::test::mutationScope() {
    return {extensionAndAccessors, viewsOf, false};
}
