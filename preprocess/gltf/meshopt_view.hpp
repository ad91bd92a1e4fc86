#pragma once

#include <nlohmann/json.hpp>

namespace edgeshade {

struct GltfDocument;

/// Whether a glTF buffer is only the fallback of EXT_ or KHR_meshopt_compression, without bytes of
/// its own.
bool isMeshoptFallback(const nlohmann::ordered_json& buffer);

/// Says of the buffers of sound `json` that are such a fallback, without saying so, that they are:
/// those without a uri to which none but compressed views refer.
void tagMeshoptFallbacks(nlohmann::ordered_json& json);

/// Decodes every buffer view that EXT_ or KHR_meshopt_compression compressed into
/// document.decodedViews. Safe on untrusted input. Throws InputError.
void decodeMeshoptViews(GltfDocument& document);

} // namespace edgeshade
