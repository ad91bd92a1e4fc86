#pragma once

#include "edgeshade/version.hpp"
#include "preprocess/gltf/extensions.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/volumes/shadow_data.hpp"

#include <optional>
#include <set>
#include <string>

namespace edgeshade {

/// The glTF extension that carries shadow data, on the asset's root, used and not required.
///
///     {
///       "version": 2,
///       "encoding": "expanded" | "indexed" | "none",
///       "maxMultiplicity": 1..5,        opposite vertices per record
///       "weldTolerance": number >= 0, "castMasked": boolean, "casterError": number >= 0,
///       "flatTolerance": number >= 0, < 45; for plane-pair records, which are built on loading
///       "instances": "auto" | "shared" | "repeated", for meshes at several places; absent in
///           older files, which repeat them
///       "batches": [{                   in the order of flattenScene(), one for all places of a
///       mesh
///         "node": index,                of the first place; absent: the batch is static
///         "positionsHash": "16 hex digits",     of the casting surfaces, not simplified
///         "simplifiedTriangles": number >= 0,                                    (casterError > 0)
///         "simplifiedCasters": accessor of unsigned integers, three per triangle: the batch's
///             vertices of the simplified casters; absent if there are none       (casterError > 0)
///         "sides", "caps": accessors of VEC4 floats, SidesData and CapsData      (expanded)
///         "edgeCount": number > 0,                                               (indexed)
///         "edgeVertices", "oppositeCounts", "oppositeVertices": accessors of unsigned bytes, the
///             streams of edge_codec.hpp: edges over the sorted welded positions  (indexed)
///       }]                              accessors are absent where a batch has no casters
///     }
inline constexpr int shadowExtensionVersion = packedFormatVersion;

enum class Encoding {
    expanded, ///< sides-data and caps-data, ready for the GPU
    indexed,  ///< edges as indices into the welded positions, compressed
    none,     ///< settings only; topology is found on loading
};

/// "expanded", "indexed", "none".
const char* nameOf(Encoding encoding);

/// A positionsHash() as the extension writes it: 16 hexadecimal digits.
std::string hashText(std::uint64_t hash);

/// The extension in a document's JSON; null if it isn't packed.
const nlohmann::ordered_json* shadowExtensionOf(const nlohmann::ordered_json& json);

/// Indices of all accessors that a sound extension refers to.
std::set<int> shadowAccessorsOf(const nlohmann::ordered_json& extension);

/// How the shadow data of a packed document were made. Checks every field of the extension and its
/// batches, but not the accessors' contents, which readShadows() checks. Throws InputError for an
/// unknown version or value.
struct ShadowHeader {
    Encoding encoding = Encoding::none;
    int maxMultiplicity = 1;
    CasterSettings settings;
};
std::optional<ShadowHeader> readShadowHeader(const GltfDocument& document);

/// Sets the document's simplified casters in `scene`, which was flattened with the header's
/// settings. Throws InputError if the batches differ from the document's, by their hashes too, and
/// for every impossible count and index.
void readCasters(const GltfDocument& document, const ShadowHeader& header, Scene& scene);

/// The document's shadow data, ready for drawing. `scene` has the casters of readCasters(). Checks
/// every offset, count and index. Throws InputError.
Shadows readShadows(const GltfDocument& document, const ShadowHeader& header, const Scene& scene);

/// Bytes of shadow data that a packed document stores; 0 if it isn't packed. Throws InputError.
std::size_t storedShadowBytes(const GltfDocument& document);

/// Appends buffer views, accessors and the extension to `json`, which must not have it yet, and the
/// bytes to `binary`, which is buffer 0.
void appendShadowExtension(nlohmann::ordered_json& json, Bytes& binary, const Scene& scene,
                           const Topologies& topology, Encoding encoding,
                           const CasterSettings& settings);

/// Removes an earlier extension, which must be sound: everything appendShadowExtension() added, and
/// the extension's name if nothing else remains of it. Sections may be left empty. `json` must have
/// no dangling indices (eraseDanglingIndices()). `path` is for messages. Throws InputError if the
/// file was rearranged since.
void removeShadowExtension(nlohmann::ordered_json& json, Bytes& binary,
                           const std::filesystem::path& path);

} // namespace edgeshade
