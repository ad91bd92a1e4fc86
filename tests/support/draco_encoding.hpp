#pragma once

#include "tests/support/gltf_builder.hpp"

namespace edgeshade::test {

inline constexpr const char* dracoExtension = "KHR_draco_mesh_compression";

/// A shape as a Draco stream: POSITION has id 0, NORMAL 1, TEXCOORD_0 2.
Bytes dracoEncoded(const Shape& shape);

/// A primitive whose data are only in Draco.
Json dracoPrimitive(GltfBuilder& gltf, const Shape& shape);

} // namespace edgeshade::test
