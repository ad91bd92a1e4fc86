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
/// empty if the file has none, otherwise as long as `positions`.
struct Primitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    /// One array for each channel of the material.
    std::array<std::vector<glm::vec2>, mostTexcoordChannels> texcoords;
    std::vector<glm::vec4> tangents; ///< with the bitangent's sign in w
    std::vector<glm::vec4> colors;   ///< linear; alpha 1 if the file has none
    Influences influences;
    std::vector<MorphTarget> targets;   ///< those kept
    std::vector<std::uint32_t> indices; ///< three per triangle, all below positions.size()
    int material = -1;
};

/// How a primitive's morph targets are used.
struct MorphUse {
    bool kept = false;           ///< the targets are kept; otherwise blended
    std::vector<double> weights; ///< for blending
};

/// Reads a primitive: accessors or KHR_draco_mesh_compression; triangles, strips or fans; morph
/// targets kept or blended; all sets of joints. Points and lines give an empty primitive and a
/// warning. Texture coordinates are those of the material's channels, not yet transformed. Tangents
/// are read if the material has a normal texture. `memory` counts what is read. Safe on untrusted
/// input. Throws InputError naming the accessor, also for NaN and infinite values.
Primitive readPrimitive(const GltfDocument& document, std::size_t mesh, std::size_t primitive,
                        const MorphUse& morphs, const Material& material, Warnings& warnings,
                        MemoryBudget& memory);

} // namespace edgeshade
