#pragma once

#include "src/hours/surfaces/surface_part.hpp"

#include <filesystem>

namespace edgeshade::hours {

/// The most bytes that a part's arrays have, before they are compressed.
inline constexpr std::uint64_t mostBytesOfPart = std::uint64_t{1} << 30;

/// The bytes of the arrays of a part that counts so many positions.
std::uint64_t bytesOfPart(const SurfaceCells& cells, std::size_t trianglesOfScene,
                          std::size_t positions);

/// The file of a part of at most mostBytesOfPart: JSON, with arrays as data URIs of zlib streams,
/// little-endian. Version 1. The same part gives the same bytes.
///
///     {"edgeshade_sunhours_surfaces_part": 1, "part": K, "parts": N, "scene": "16 hex digits",
///      "version", "files": [...], "settings": {...}, "warnings": [...], "positions_of_run": P,
///      "positions": [{"time", "azimuth", "altitude", "direction"}, ...],
///      "beam": null or P doubles, "materials": [{"index", "name"}, ...], "nodes": [...],
///      "triangles": {"count", "corners": 9 doubles, "node", "material": 32 bits, "chosen": 8},
///      "cells": {"count", "point", "normal": 3 doubles, "area": double,
///                "triangle", "first_face", "face_count": 32 bits, "state": 8},
///      "faces": {"count", "first_corner", "corner_count": 32 bits},
///      "corners": {"count", "point": 3 doubles},
///      "bits": a row for each cell, as CellLight::bits}
std::string textOf(const SurfacePart& part);

/// Whether the file says that it is a part of surfaces. Throws InputError.
bool isSurfacePart(const nlohmann::ordered_json& json);

/// Reads a part from its file's JSON. Safe on untrusted input. Throws InputError naming file, field
/// and value for every error: the result satisfies all of SurfacePart's rules.
SurfacePart surfacePartFrom(const std::filesystem::path& path, const nlohmann::ordered_json& json);

} // namespace edgeshade::hours
