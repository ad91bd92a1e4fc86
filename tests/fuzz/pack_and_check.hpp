#pragma once

#include <cstdint>
#include <span>

namespace edgeshade::test {

/// Packs the bytes of a .glb or .gltf as `pack` does, with an encoding and settings derived from
/// the bytes, and checks the packed file: it is read back as the same scene with the same images,
/// its shadow data are those that were found, its structure has no fault that the source hasn't
/// (gltf_structure.hpp), and packing it again gives the same bytes. Limits are small.
///
/// Refusals must be one sentence; if one isn't, or a check fails, it ends the process (abort).
/// Returns whether the bytes were packed.
bool packAndCheck(std::span<const std::uint8_t> bytes);

} // namespace edgeshade::test
