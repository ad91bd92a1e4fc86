#pragma once

#include <nlohmann/json.hpp>

namespace edgeshade {

struct GltfDocument;

/// Whether a glTF buffer is only the fallback of EXT_ or KHR_meshopt_compression, without its own
/// bytes.
bool isMeshoptFallback(const nlohmann::ordered_json& buffer);

/// Tags buffers of sound `json` that are untagged meshopt fallbacks: those without a uri to which
/// only compressed views refer.
void tagMeshoptFallbacks(nlohmann::ordered_json& json);

/// Decompresses every buffer view of EXT_ or KHR_meshopt_compression into document.decodedViews.
/// Safe on untrusted input. Throws InputError.
void decodeMeshoptViews(GltfDocument& document);

} // namespace edgeshade
