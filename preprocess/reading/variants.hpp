#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// Names of the document's variants (KHR_materials_variants), by index; empty for a name that is
/// missing or isn't text.
std::vector<std::string> variantNames(const GltfDocument& document);

/// The index of the variant with that name. Null for an empty name; also null for an unknown one,
/// with a warning that lists the known names.
std::optional<std::size_t> findVariant(const GltfDocument& document, const std::string& name,
                                       Warnings& warnings);

/// The material of a primitive in a variant. It is the primitive's own material if the variant has
/// none for it, or an invalid one, which gets a warning.
int materialInVariant(const GltfDocument& document, std::size_t mesh, std::size_t primitive,
                      const std::optional<std::size_t>& variant, Warnings& warnings);

} // namespace edgeshade
