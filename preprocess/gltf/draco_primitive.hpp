#pragma once

#include "preprocess/gltf/accessor.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// A primitive decoded from KHR_draco_mesh_compression: attributes by glTF name and a triangle
/// list, all indices in range.
struct DracoPrimitive {
    std::map<std::string, FloatArray> attributes;
    std::vector<std::uint32_t> indices;
};

/// Decodes the primitive if it carries the extension. `field` names it in messages. Safe on
/// untrusted input as far as the Draco decoder is; takes no memory that the stream's size does not
/// bear out or `memory` does not have. Throws InputError.
std::optional<DracoPrimitive> readDracoPrimitive(const GltfDocument& document,
                                                 const tinygltf::Primitive& primitive,
                                                 const std::string& field, MemoryBudget& memory);

} // namespace edgeshade
