#include "preprocess/reading/skin.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

namespace edgeshade {

std::vector<glm::dmat4> skinMatrices(const GltfDocument& document, int skin,
                                     const std::vector<glm::dmat4>& worldFromNode,
                                     MemoryBudget& memory) {
    const std::string field = "skins[" + std::to_string(skin) + "]";
    if (skin < 0 || static_cast<std::size_t>(skin) >= document.model->skins.size())
        throw InputError(document.where(field) + " does not exist.");
    const tinygltf::Skin& source = document.model->skins[skin];
    FloatArray inverseBind;
    memory.take(source.joints.size(), sizeof(glm::dmat4), document.where(field));
    if (source.inverseBindMatrices >= 0) {
        inverseBind = readFloats(document, source.inverseBindMatrices,
                                 field + ".inverseBindMatrices", memory);
        if (inverseBind.components != 16 || inverseBind.count() < source.joints.size())
            throw InputError(document.where(field) + ".inverseBindMatrices does not hold a 4x4 "
                                                     "matrix for every joint.");
    }
    std::vector<glm::dmat4> matrices;
    for (std::size_t j = 0; j < source.joints.size(); ++j) {
        const int node = source.joints[j];
        if (node < 0 || static_cast<std::size_t>(node) >= worldFromNode.size())
            throw InputError(document.where(field) + ".joints[" + std::to_string(j) + "] is " +
                             std::to_string(node) + ", which does not exist.");
        glm::dmat4 bind(1.0);
        if (inverseBind.components == 16)
            for (glm::length_t i = 0; i < 16; ++i)
                bind[i / 4][i % 4] = inverseBind.values[16 * j + i];
        matrices.push_back(worldFromNode[node] * bind);
    }
    return matrices;
}

glm::dmat4 skinMatrixOf(const Primitive& primitive, std::size_t vertex,
                        const std::vector<glm::dmat4>& matrices, const GltfDocument& document) {
    glm::dmat4 blended(0.0);
    double total = 0.0;
    for (glm::length_t i = 0; i < 4; ++i) {
        const double weight = primitive.weights[vertex][i];
        if (weight == 0.0) continue;
        const std::uint32_t joint = primitive.joints[vertex][i];
        if (joint >= matrices.size())
            throw InputError(document.where("JOINTS_0") + " names joint " + std::to_string(joint) +
                             ", but the skin has " + std::to_string(matrices.size()) + ".");
        blended += weight * matrices[joint];
        total += weight;
    }
    return total == 0.0 ? glm::dmat4(1.0) : blended / total;
}

} // namespace edgeshade
