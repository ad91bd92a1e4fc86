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

/// A glTF 2.0 asset in memory: what it says and the bytes it refers to.
///
/// `model` is tinygltf's typed view of `json`, for gltf/ and reading/ alone, which look into it by
/// tinygltf_model.hpp; its own buffers and images stay empty. Bytes are reached through
/// bufferViewBytes(), which has checked every bound.
struct GltfDocument {
    std::filesystem::path path;                   ///< as the user named it, for messages
    nlohmann::ordered_json json;                  ///< the source, key order kept
    std::shared_ptr<const tinygltf::Model> model; ///< the same, typed; never null once it was read
    std::vector<Bytes> buffers; ///< one a glTF buffer; empty for meshopt fallbacks
    std::vector<std::optional<Bytes>> decodedViews; ///< one a view; what meshopt compressed
    Warnings warnings;                              ///< of parsing; flattenScene() hands them on
    MemoryBudget memory; ///< what parsing took; whoever makes more of it goes on with a copy

    /// An error message's start: the file's name and the field.
    std::string where(const std::string& field) const {
        return "'" + path.string() + "': " + field;
    }
};

/// The bytes that `uri`, the value of `field`, names: a data URI's, or a file's of the asset's own
/// folder or below it, links that lead out of it not followed. Throws InputError, LimitError if the
/// file is too large.
Bytes resolveUri(const GltfDocument& document, const std::string& field, const std::string& uri);

/// The bytes of a buffer view, decoded if it was compressed. Throws InputError if the index or the
/// range is invalid.
std::span<const std::uint8_t> bufferViewBytes(const GltfDocument& document, int view);

/// The bytes of image `image`, still encoded, from a view, a data URI or a file. Throws InputError,
/// LimitError if the file is too large.
Bytes encodedImageBytes(const GltfDocument& document, int image);

} // namespace edgeshade
