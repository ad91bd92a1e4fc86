#pragma once

#include "preprocess/base/file_io.hpp"
#include "src/hours/part.hpp"

#include <filesystem>

namespace edgeshade::hours {

/// A part's file: JSON, with arrays of pixels as data URIs of zlib streams, little-endian. Version
/// 1. The same part gives the same bytes. Throws Error(unavailable) for more than 2^28 pixels.
///
///     {"edgeshade_sunhours_part": 1, "part": K, "parts": N, "scene": "16 hex digits",
///      "settings": {...}, "camera": {...}, "warnings": [...], "positions_of_run": P,
///      "positions": [{"time", "azimuth", "altitude", "direction"}, ...],
///      "probes": [{"point", "normal" or null, "lit": "0110..."}, ...],
///      "materials": [{"index", "name"}, ...], "nodes": [...], "size": [W, H],
///      "pixels": {"lit" 16 bits, "surface" 8, "area" float, "material" 32, "node" 32}}
std::string textOf(const Part& part);

/// Reads a part from a file. Safe on untrusted input. Throws InputError naming file, field and
/// value for every error: the result satisfies all of Part's rules.
Part partFrom(const std::filesystem::path& path);
/// The same, from the file's JSON.
Part partFrom(const std::filesystem::path& path, const nlohmann::ordered_json& json);

/// A position in the format of parts and reports.
nlohmann::ordered_json jsonOf(const Position& position, std::chrono::minutes offset);

} // namespace edgeshade::hours
