#pragma once

#include <nlohmann/json.hpp>

namespace edgeshade {

struct GltfDocument;

/// Whether a glTF buffer is only the fallback of EXT_meshopt_compression, without bytes of its own.
bool isMeshoptFallback(const nlohmann::ordered_json& buffer);

/// Decodes every buffer view that EXT_meshopt_compression compressed into
/// document.decodedViews. Safe on untrusted input. Throws InputError.
void decodeMeshoptViews(GltfDocument& document);

} // namespace edgeshade
