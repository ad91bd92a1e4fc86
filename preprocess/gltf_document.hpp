#pragma once

#include "preprocess/file_io.hpp"
#include "preprocess/limits.hpp"
#include "preprocess/warnings.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace edgeshade {

/// A glTF 2.0 asset in memory: what it says and the bytes it refers to.
///
/// `model` is tinygltf's typed view of `json`; its own buffers and images stay empty. Bytes are
/// reached through bufferViewBytes(), which has checked every bound.
struct GltfDocument {
    std::filesystem::path path;  ///< as the user named it, for messages
    nlohmann::ordered_json json; ///< the source, key order kept
    tinygltf::Model model;       ///< the same, typed
    std::vector<Bytes> buffers;  ///< one a glTF buffer; empty for meshopt fallbacks
    std::vector<std::optional<Bytes>> decodedViews; ///< compressed by meshopt, decoded
    Warnings warnings;                              ///< of parsing; flattenScene() hands them on
    MemoryBudget memory; ///< what parsing took; whoever makes more of it goes on with a copy

    /// An error message's start: the file's name and the field.
    std::string where(const std::string& field) const {
        return "'" + path.string() + "': " + field;
    }
};

/// Reads a .gltf with its files or a .glb. External files are taken from the asset's own folder
/// (or below it) alone, links that lead out of it not followed. Safe on untrusted input. Throws
/// InputError.
GltfDocument readGltf(const std::filesystem::path& path, const ReadingLimits& limits = {});

/// The same from bytes; `path` gives the folder of external files and the name in messages.
GltfDocument parseGltf(std::span<const std::uint8_t> bytes, const std::filesystem::path& path,
                       const ReadingLimits& limits = {});

/// The bytes of a buffer view, decoded if it was compressed. Throws InputError if the index or the
/// range is invalid.
std::span<const std::uint8_t> bufferViewBytes(const GltfDocument& document, int view);

/// The bytes of image `image`, still encoded, from a view, a data URI or a file. Throws InputError,
/// LimitError if the file is too large.
Bytes encodedImageBytes(const GltfDocument& document, int image);

} // namespace edgeshade
