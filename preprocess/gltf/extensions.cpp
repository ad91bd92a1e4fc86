#include "preprocess/gltf/extensions.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

using enum ExtensionUse;

constexpr KnownExtension known[] = {
    {"CESIUM_RTC", drawn},
    {"CESIUM_primitive_outline", metadata},
    {shadowExtensionName, drawn},
    {"EXT_mesh_features", metadata},
    {"EXT_mesh_gpu_instancing", drawn},
    {"EXT_meshopt_compression", drawn},
    {"EXT_structural_metadata", metadata},
    {"EXT_texture_webp", drawn},
    {"FB_ngon_encoding", metadata},
    {"KHR_draco_mesh_compression", drawn},
    {"KHR_lights_punctual", drawn},
    {"KHR_materials_anisotropy", ignored, "anisotropic highlights are not drawn"},
    {"KHR_materials_clearcoat", drawn},
    {"KHR_materials_diffuse_transmission", ignored,
     "light that shines through thin surfaces is not drawn"},
    {"KHR_materials_dispersion", ignored, "dispersion in glass is not drawn"},
    {"KHR_materials_emissive_strength", drawn},
    {"KHR_materials_ior", drawn},
    {"KHR_materials_iridescence", ignored, "iridescence is not drawn"},
    {"KHR_materials_pbrSpecularGlossiness", drawn},
    {"KHR_materials_sheen", ignored, "sheen is not drawn"},
    {"KHR_materials_specular", drawn},
    {"KHR_materials_transmission", drawn, "glass is blended, without refraction"},
    {"KHR_materials_unlit", drawn},
    {"KHR_materials_variants", drawn},
    {"KHR_materials_volume", ignored, "light absorption within glass is not drawn"},
    {"KHR_mesh_quantization", drawn},
    {"KHR_meshopt_compression", drawn},
    {"KHR_node_visibility", drawn},
    {"KHR_texture_basisu", ignored}, // each such image gets its own warning
    {"KHR_texture_transform", drawn},
    {"KHR_xmp_json_ld", metadata},
};

} // namespace

std::span<const KnownExtension> knownExtensions() {
    return known;
}

void checkExtensions(const JsonField& root, Warnings& warnings) {
    root.ifPresent("extensions", [](const JsonField& field) { field.requireObject(); });
    root.ifPresent("extensionsUsed", [](const JsonField& field) {
        field.forEachItem([](const JsonField& name) { name.text(); });
    });
    root.ifPresent("extensionsRequired", [&](const JsonField& field) {
        field.forEachItem([&](const JsonField& item) {
            const std::string name = item.text();
            const auto found = std::find_if(
                std::begin(known), std::end(known),
                [&](const KnownExtension& extension) { return name == extension.name; });
            if (found == std::end(known))
                item.fail(" is '" + name + "', an extension that this program does not know");
            if (found->lack)
                readOrWarn(warnings, found->lack, [&] { item.fail(" is '" + name + "'"); });
        });
    });
}

} // namespace edgeshade
