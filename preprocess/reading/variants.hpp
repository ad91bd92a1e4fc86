#pragma once

#include "preprocess/gltf/gltf_document.hpp"

#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// The names of the document's variants (KHR_materials_variants), by index; empty text for one
/// whose name is missing or no text.
std::vector<std::string> variantNames(const GltfDocument& document);

/// The index of the variant of that name. Null for no name, and for one that the document does not
/// have, with a warning that lists those it has.
std::optional<std::size_t> findVariant(const GltfDocument& document, const std::string& name,
                                       Warnings& warnings);

/// The material of a primitive in a variant; the primitive's own where the variant does not say, or
/// says it in a broken way, with a warning.
int materialInVariant(const GltfDocument& document, std::size_t mesh, std::size_t primitive,
                      const std::optional<std::size_t>& variant, Warnings& warnings);

} // namespace edgeshade
