#pragma once

#include "preprocess/gltf/accessor.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// A primitive decoded from KHR_draco_mesh_compression: attributes by glTF name and a triangle
/// list, all of whose indices are in range.
struct DracoPrimitive {
    std::map<std::string, FloatArray> attributes;
    std::vector<std::uint32_t> indices;
};

/// Decodes the primitive if it has the extension. `field` names it in messages. As safe on
/// untrusted input as the Draco decoder. Allocates no more than the stream's size makes plausible
/// and `memory` allows. Throws InputError.
std::optional<DracoPrimitive> readDracoPrimitive(const GltfDocument& document,
                                                 const tinygltf::Primitive& primitive,
                                                 const std::string& field, MemoryBudget& memory);

} // namespace edgeshade
