#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/json_field.hpp"

#include <span>

namespace edgeshade {

/// Our own, which carries shadow data (preprocess/packing/shadow_extension.hpp).
inline constexpr const char* shadowExtensionName = "EDGESHADE_shadow_volume";

/// What becomes of an extension that an asset requires.
enum class ExtensionUse {
    drawn,    ///< what it says is in the picture
    ignored,  ///< the picture lacks what it says; geometry and shadows are right
    metadata, ///< there is nothing in it to draw
};

struct KnownExtension {
    const char* name;
    ExtensionUse use;
    /// Of an ignored one: what becomes of it, to end a warning with. Null: no warning names it.
    const char* lack = nullptr;
};

/// All extensions that an asset may require, by name.
std::span<const KnownExtension> knownExtensions();

/// Looks through the asset's lists of extensions: warns once of each that it requires and that is
/// ignored, where there is something to say of it. Throws InputError where it requires one that is
/// not known.
void checkExtensions(const JsonField& root, Warnings& warnings);

} // namespace edgeshade
