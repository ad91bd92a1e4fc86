#pragma once

#include "preprocess/packing/shadow_extension.hpp"

namespace edgeshade {

/// A GLB of `document` without its empty sections, with its external buffers and images embedded,
/// and with the shadow data of `topology`. Compressed geometry stays compressed. The same input
/// gives the same bytes. An image that can't be embedded stays as it is, with a warning. Throws
/// InputError.
Bytes packedGlb(const GltfDocument& document, const Scene& scene, const Topologies& topology,
                Encoding encoding, const CasterSettings& settings, Warnings& warnings);

} // namespace edgeshade
