#pragma once

#include <cstdint>
#include <span>

namespace edgeshade::test {

/// Reads the bytes of a .glb or .gltf as the program would in all of its verbs, short of drawing:
/// read -> flatten -> weld -> edges -> plane-pair records, the shadow data of a packed file, its
/// animation, its images; and packs it again. Limits are small, so that little memory and time are
/// enough for whatever is accepted.
///
/// What is refused must be refused in one sentence; ends the process (abort) if it is not. Returns
/// whether everything was accepted.
bool readEverything(std::span<const std::uint8_t> bytes);

/// The same of an image alone, PNG or JPEG.
bool readImage(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::test
