#pragma once

#include "preprocess/packing/shadow_extension.hpp"

namespace edgeshade {

/// A GLB with everything of `document` but empty sections, its external buffers and images
/// embedded, and the shadow data of `topology`. Compressed geometry stays compressed. Same input,
/// same bytes. An image that can't be embedded stays as it is, with a warning. Throws InputError.
Bytes packedGlb(const GltfDocument& document, const Scene& scene, const Topologies& topology,
                Encoding encoding, const CasterSettings& settings, Warnings& warnings);

} // namespace edgeshade
