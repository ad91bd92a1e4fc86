#pragma once

#include "preprocess/gltf/extensions.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/volumes/shadow_data.hpp"

#include <optional>
#include <set>
#include <string>

namespace edgeshade {

/// The glTF extension that carries shadow data, on the asset's root, used and not required.
///
/// {
///   "version": 2,
///   "encoding": "expanded" | "indexed" | "none",
///   "maxMultiplicity": 1..5,        opposite vertices a record
///   "weldTolerance": number >= 0, "castMasked": boolean, "casterError": number >= 0,
///   "flatTolerance": number >= 0, < 45; of plane-pair records, which are made at load
///   "instances": "auto" | "shared" | "repeated", how meshes of several places are kept; absent in
///       older files, which repeat them
///   "batches": [{                   in the order of flattenScene(), one for all places of a mesh
///     "node": index,                of the first place; absent: it is static
///     "positionsHash": "16 hex digits",     of the surfaces that cast, not simplified
///     "simplifiedTriangles": number >= 0,                                    (casterError > 0)
///     "simplifiedCasters": accessor of unsigned integers, three a triangle, which vertices of
///         the batch the simplified casters join; absent where there are none (casterError > 0)
///     "sides", "caps": accessors of VEC4 floats, SidesData and CapsData      (expanded)
///     "edgeCount": number > 0,                                               (indexed)
///     "edgeVertices", "oppositeCounts", "oppositeVertices": accessors of unsigned bytes, the
///         streams of edge_codec.hpp: edges over the sorted welded positions  (indexed)
///   }]                              accessors are absent where a batch has no casters
/// }
inline constexpr int shadowExtensionVersion = 2;

enum class Encoding {
    expanded, ///< GPU-ready sides-data and caps-data
    indexed,  ///< edges as indices into the welded positions, compressed
    none,     ///< nothing but the settings; topology is found at load
};

/// "expanded", "indexed", "none".
const char* nameOf(Encoding encoding);

/// A positionsHash() as the extension spells it: 16 hexadecimal digits.
std::string hashText(std::uint64_t hash);

/// The extension in a document's JSON; null: it isn't packed.
const nlohmann::ordered_json* shadowExtensionOf(const nlohmann::ordered_json& json);

/// Indices of all accessors that a sound extension refers to.
std::set<int> shadowAccessorsOf(const nlohmann::ordered_json& extension);

/// How the shadow data of a packed document were made. Checks every field of the extension, those
/// of its batches included; what accessors hold is up to readShadows(). Throws InputError for a
/// version or a value that is not known.
struct ShadowHeader {
    Encoding encoding = Encoding::none;
    int maxMultiplicity = 1;
    CasterSettings settings;
};
std::optional<ShadowHeader> readShadowHeader(const GltfDocument& document);

/// Gives `scene`, the document's flattened with the header's settings, the simplified casters that
/// the document holds. Throws InputError where batches are not those of the document, by their
/// hashes too, and for every count and index that can't be.
void readCasters(const GltfDocument& document, const ShadowHeader& header, Scene& scene);

/// The shadow data that the document holds, made ready for drawing. `scene`: with its casters, by
/// readCasters(). Checks every offset, count and index. Throws InputError.
Shadows readShadows(const GltfDocument& document, const ShadowHeader& header, const Scene& scene);

/// Bytes of shadow data that a packed document stores; 0 if it isn't packed. Throws InputError.
std::size_t storedShadowBytes(const GltfDocument& document);

/// Appends buffer views, accessors and the extension, which `json` must not have, to `json`, and
/// the bytes to `binary`, which is buffer 0.
void appendShadowExtension(nlohmann::ordered_json& json, Bytes& binary, const Scene& scene,
                           const Topologies& topology, Encoding encoding,
                           const CasterSettings& settings);

/// Takes an earlier extension out again, which must be sound: what appendShadowExtension() added,
/// and its name where that is all there is. Sections may be empty then. `json` must have no
/// dangling indices (eraseDanglingIndices()). `path` is for messages. Throws InputError if the file
/// was rearranged since.
void removeShadowExtension(nlohmann::ordered_json& json, Bytes& binary,
                           const std::filesystem::path& path);

} // namespace edgeshade
