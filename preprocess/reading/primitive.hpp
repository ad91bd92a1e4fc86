#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/gltf_document.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// One glTF mesh primitive as a triangle list, decompressed, in mesh space. Attribute arrays are
/// empty where the file has none, else as long as `positions`.
struct Primitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> texcoords; ///< the set that the base colour texture uses
    std::vector<glm::vec4> colors;    ///< linear, alpha 1 where the file has none
    std::vector<glm::uvec4> joints;
    std::vector<glm::vec4> weights;
    std::vector<std::uint32_t> indices; ///< three a triangle, all below positions.size()
    int material = -1;
};

/// Reads a primitive: accessors or KHR_draco_mesh_compression, triangles, strips or fans, morph
/// targets blended with `morphWeights`. Points and lines give an empty primitive and a warning.
/// `texcoordSet` picks TEXCOORD_n; `memory` counts what is read. Safe on untrusted input. Throws
/// InputError, also for values that are NaN or infinite, naming the accessor.
Primitive readPrimitive(const GltfDocument& document, std::size_t mesh, std::size_t primitive,
                        const std::vector<double>& morphWeights, int texcoordSet,
                        Warnings& warnings, MemoryBudget& memory);

} // namespace edgeshade
