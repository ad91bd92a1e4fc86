#pragma once

#include <cstdint>
#include <span>

namespace edgeshade::test {

/// Reads the bytes of a .glb or .gltf as all of the program's verbs would, short of drawing: read
/// -> flatten -> weld -> edges -> plane-pair records, the shadow data of a packed file, its
/// animation, its images; and packs it again. Limits are small, so that all accepted inputs need
/// little memory and time.
///
/// Refusals must be one sentence; otherwise it ends the process (abort). Returns whether everything
/// was accepted.
bool readEverything(std::span<const std::uint8_t> bytes);

/// The same for a single image, PNG or JPEG.
bool readImage(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::test
