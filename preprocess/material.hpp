#pragma once

#include "preprocess/gltf_document.hpp"
#include "preprocess/sampler.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

enum class AlphaMode { opaque, mask, blend };

/// What of a glTF material this program draws: its base colour and whether light gets through.
struct Material {
    AlphaMode alphaMode = AlphaMode::opaque;
    bool unlit = false; ///< KHR_materials_unlit: its colour as it is; it casts all the same
    float alphaCutoff = 0.5f;
    glm::vec4 baseColorFactor{1.0f}; ///< linear; pbrSpecularGlossiness' diffuse where used
    int texture = -1;                ///< of the base colour, as the file says; -1: none
    int image = -1;                  ///< that is drawn of it, as ImageChoice decides; -1: none
    Sampler sampler;                 ///< of this texture
    int texcoordSet = 0;
    glm::mat3 uvTransform{1.0f}; ///< KHR_texture_transform: uv' = uvTransform * (u, v, 1)
};

/// All materials of the document; the default material stands at the end, and a primitive without
/// a material uses it. Throws InputError.
std::vector<Material> readMaterials(const GltfDocument& document);

} // namespace edgeshade
