#include "preprocess/reading/texture_sources.hpp"

#include "preprocess/gltf/json_field.hpp"

namespace edgeshade {
namespace {

/// Runs `action`, and turns an InputError into a warning.
template <class Action>
void orLeaveOut(Warnings& warnings, Action action) {
    try {
        action();
    } catch (const InputError& error) {
        warnings.add(clauseOf(error.what()) + "; it is left out.");
    }
}

} // namespace

std::vector<int> sourcesOf(const GltfDocument& document, std::size_t texture, Warnings& warnings) {
    const JsonField root(document.path, document.json);
    const auto images = root.find("images");
    const JsonField textures = root.member("textures");
    const JsonField field = textures.item(texture);
    std::vector<int> sources;
    bool named = false;
    const auto addFrom = [&](const JsonField& object) {
        orLeaveOut(warnings, [&] {
            const auto source = object.find("source");
            if (!source) return;
            named = true;
            sources.push_back(source->indexInto(images ? images->size() : 0, "images"));
        });
    };
    const auto addFromExtension = [&](const char* name) {
        orLeaveOut(warnings, [&] {
            const auto extensions = field.find("extensions");
            const auto extension = extensions ? extensions->find(name) : std::nullopt;
            if (extension) addFrom(*extension);
        });
    };
    addFromExtension("EXT_texture_webp");
    addFrom(field);
    addFromExtension("KHR_texture_basisu");
    if (!named) orLeaveOut(warnings, [&] { field.fail(" has no source"); });
    return sources;
}

} // namespace edgeshade
