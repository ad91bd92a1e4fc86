#pragma once

#include "preprocess/base/warnings.hpp"
#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/scene/deformation.hpp"
#include "preprocess/scene/material.hpp"

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// One glTF mesh primitive as a triangle list, decompressed, in mesh space. Attribute arrays are
/// empty where the file has none, else as long as `positions`.
struct Primitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    /// One array for each channel that was asked for.
    std::array<std::vector<glm::vec2>, mostTexcoordChannels> texcoords;
    std::vector<glm::vec4> tangents; ///< with the bitangent's sign
    std::vector<glm::vec4> colors;   ///< linear, alpha 1 where the file has none
    Influences influences;
    std::vector<MorphTarget> targets;   ///< those that were kept
    std::vector<std::uint32_t> indices; ///< three a triangle, all below positions.size()
    int material = -1;
};

/// What becomes of a primitive's morph targets.
struct MorphUse {
    bool kept = false;           ///< they are read as they are; else blended
    std::vector<double> weights; ///< to blend with
};

/// Reads a primitive: accessors or KHR_draco_mesh_compression, triangles, strips or fans, morph
/// targets kept or blended, all sets of joints. Points and lines give an empty primitive and a
/// warning.
/// Texture coordinates are those of the material's channels, not yet transformed; tangents are read
/// where it has normals by texture. `memory` counts what is read. Safe on untrusted input. Throws
/// InputError, also for values that are NaN or infinite, naming the accessor.
Primitive readPrimitive(const GltfDocument& document, std::size_t mesh, std::size_t primitive,
                        const MorphUse& morphs, const Material& material, Warnings& warnings,
                        MemoryBudget& memory);

} // namespace edgeshade
