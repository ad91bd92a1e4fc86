// KHR_draco_mesh_compression and EXT_meshopt_compression: the compressed bytes and the extensions'
// fields change, the rest of the file stays sound.
#include "tests/fuzz/glb_mutation.hpp"

using namespace edgeshade::test;

namespace {

/// Finds the compression extensions of views and primitives at any depth.
void findExtensions(Json& value, std::vector<Json*>& found) {
    if (!value.is_structured()) return;
    if (value.is_object())
        for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
            if (value.contains(name)) found.push_back(&value[name]);
    for (Json& child : value)
        findExtensions(child, found);
}

std::vector<Json*> extensionsOf(Json& json) {
    std::vector<Json*> found;
    findExtensions(json, found);
    return found;
}

/// The ranges of compressed bytes: of the meshopt extension itself, and of the views that Draco
/// names.
std::vector<Json*> compressedRanges(Json& json) {
    std::vector<Json*> ranges;
    const std::vector<Json*> views = bufferViewsOf(json);
    for (Json* extension : extensionsOf(json)) {
        if (!extension->is_object()) continue;
        if (extension->contains("byteLength")) ranges.push_back(extension);
        if (!extension->contains("bufferView")) continue;
        const Json& view = (*extension)["bufferView"];
        if (view.is_number_unsigned() && view.get<std::size_t>() < views.size())
            ranges.push_back(views[view.get<std::size_t>()]);
    }
    return ranges;
}

} // namespace

MutationScope edgeshade::test::mutationScope() {
    return {extensionsOf, compressedRanges, false};
}
