#pragma once

#include <cstdint>
#include <span>

namespace edgeshade::test {

/// Packs the bytes of a .glb or .gltf as `pack` does, with an encoding and settings that the bytes
/// themselves choose, and checks the packed file: it is read again as the same scene with the same
/// pictures, its shadow data are those that were found, its structure has no fault that the source
/// has not (gltf_structure.hpp), and packing it once more gives the same bytes. Limits are small.
///
/// What is refused must be refused in one sentence; ends the process (abort) where that or one of
/// the checks fails. Returns whether the bytes were packed.
bool packAndCheck(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::test
