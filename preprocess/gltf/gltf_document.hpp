#pragma once

#include "preprocess/base/file_io.hpp"
#include "preprocess/base/limits.hpp"
#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/tinygltf_fwd.hpp"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeshade {

/// A glTF 2.0 asset in memory: its JSON and the bytes it refers to.
///
/// `model` is tinygltf's typed view of `json`. Only gltf/ and reading/ use it, through
/// tinygltf_model.hpp; its own buffers and images stay empty. Bytes are read through
/// bufferViewBytes(), which checks every bound.
struct GltfDocument {
    std::filesystem::path path;                   ///< as the user gave it, for messages
    nlohmann::ordered_json json;                  ///< the source, in its key order
    std::shared_ptr<const tinygltf::Model> model; ///< typed `json`; never null after reading
    std::vector<Bytes> buffers; ///< one per glTF buffer; empty for meshopt fallbacks
    std::vector<std::optional<Bytes>> decodedViews; ///< one per view, for those that meshopt
                                                    ///< compressed
    Warnings warnings;                              ///< from parsing; flattenScene() passes them on
    MemoryBudget memory; ///< used by parsing; later stages continue with a copy

    /// The start of an error message: the file's name and the field.
    std::string where(const std::string& field) const {
        return "'" + path.string() + "': " + field;
    }
};

/// The bytes of `uri`, the value of `field`: from a data URI, or from a file in the asset's own
/// folder or below it. Links that lead out of the folder are not followed. Throws InputError, or
/// LimitError if the file is too large.
Bytes resolveUri(const GltfDocument& document, const std::string& field, const std::string& uri);

/// The bytes of a buffer view, decompressed. Throws InputError if the index or the range is
/// invalid.
std::span<const std::uint8_t> bufferViewBytes(const GltfDocument& document, int view);

/// The encoded bytes of image `image`, from a view, a data URI or a file. Throws InputError, or
/// LimitError if the file is too large.
Bytes encodedImageBytes(const GltfDocument& document, int image);

} // namespace edgeshade
