#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/json_field.hpp"

#include <span>

namespace edgeshade {

/// This program's own extension, which carries shadow data
/// (preprocess/packing/shadow_extension.hpp).
inline constexpr const char* shadowExtensionName = "EDGESHADE_shadow_volume";

/// How this program treats an extension that an asset requires.
enum class ExtensionUse {
    drawn,    ///< fully drawn
    ignored,  ///< not drawn; geometry and shadows are still right
    metadata, ///< holds nothing to draw
};

struct KnownExtension {
    const char* name;
    ExtensionUse use;
    /// For an ignored one, the consequence that ends the warning. Null: no warning names it.
    const char* lack = nullptr;
};

/// All extensions that an asset may require, by name.
std::span<const KnownExtension> knownExtensions();

/// Checks the asset's lists of extensions. Warns once of each required extension that is ignored
/// and has a `lack`. Throws InputError if an unknown one is required.
void checkExtensions(const JsonField& root, Warnings& warnings);

} // namespace edgeshade
