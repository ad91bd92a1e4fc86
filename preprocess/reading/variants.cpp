#include "preprocess/reading/variants.hpp"

#include "preprocess/gltf/json_field.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

constexpr const char* variantsExtension = "KHR_materials_variants";

/// Calls use(mappings) with the primitive's list of materials by variant, if it has one.
template <class Use>
void withMappings(const GltfDocument& document, std::size_t mesh, std::size_t primitive, Use use) {
    const std::string name =
        "meshes[" + std::to_string(mesh) + "].primitives[" + std::to_string(primitive) + "]";
    const auto& source = document.json.at("meshes").at(mesh).at("primitives").at(primitive);
    const JsonField field(document.path, source, name.c_str());
    field.ifExtension(variantsExtension,
                      [&](const JsonField& extension) { use(extension.member("mappings")); });
}

} // namespace

std::vector<std::string> variantNames(const GltfDocument& document) {
    std::vector<std::string> names;
    const auto add = [&names](const JsonField& variant) {
        const auto& value = variant.value();
        const bool named = value.is_object() && value.contains("name") && value["name"].is_string();
        names.push_back(named ? value["name"].get<std::string>() : "");
    };
    const JsonField root(document.path, document.json);
    root.ifExtension(variantsExtension, [&](const JsonField& extension) {
        if (!extension.value().is_object()) return;
        extension.ifPresent("variants", [&](const JsonField& variants) {
            if (variants.value().is_array()) variants.forEachItem(add);
        });
    });
    return names;
}

std::optional<std::size_t> findVariant(const GltfDocument& document, const std::string& name,
                                       Warnings& warnings) {
    if (name.empty()) return std::nullopt;
    const std::vector<std::string> names = variantNames(document);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string all;
    for (const std::string& known : names)
        all += (all.empty() ? "'" : ", '") + known + "'";
    warnings.add("'" + document.path.string() + "' has no variant '" + name + "'; " +
                 (all.empty() ? "it has none" : "it has " + all) + ".");
    return std::nullopt;
}

int materialInVariant(const GltfDocument& document, std::size_t mesh, std::size_t primitive,
                      const std::optional<std::size_t>& variant, Warnings& warnings) {
    int material = document.model->meshes[mesh].primitives[primitive].material;
    if (!variant) return material;
    readOrWarn(warnings, "the variant is not drawn there", [&] {
        withMappings(document, mesh, primitive, [&](const JsonField& mappings) {
            mappings.forEachItem([&](const JsonField& mapping) {
                mapping.member("variants").forEachItem([&](const JsonField& index) {
                    if (index.wholeNumber() == *variant)
                        material = mapping.member("material")
                                       .indexInto(document.model->materials.size(), "materials");
                });
            });
        });
    });
    return material;
}

} // namespace edgeshade
