#include "preprocess/reading/skin.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/tinygltf_model.hpp"

namespace edgeshade {

std::vector<Joint> readJoints(const GltfDocument& document, int skin,
                              const std::vector<NodePlace>& placeOf, MemoryBudget& memory) {
    const std::string field = "skins[" + std::to_string(skin) + "]";
    if (skin < 0 || static_cast<std::size_t>(skin) >= document.model->skins.size())
        throw InputError(document.where(field) + " does not exist.");
    const tinygltf::Skin& source = document.model->skins[skin];
    FloatArray inverseBind;
    memory.take(source.joints.size(), sizeof(Joint), document.where(field));
    if (source.inverseBindMatrices >= 0) {
        const std::string bindField = field + ".inverseBindMatrices";
        inverseBind = readFloats(document, source.inverseBindMatrices, bindField, memory);
        if (inverseBind.components != 16 || inverseBind.count() < source.joints.size())
            throw InputError(document.where(bindField) +
                             " does not hold a 4x4 matrix for every joint.");
    }
    std::vector<Joint> joints;
    for (std::size_t j = 0; j < source.joints.size(); ++j) {
        const int node = source.joints[j];
        if (node < 0 || static_cast<std::size_t>(node) >= placeOf.size())
            throw InputError(document.where(field) + ".joints[" + std::to_string(j) + "] is " +
                             std::to_string(node) + ", which does not exist.");
        Joint& joint = joints.emplace_back(Joint{placeOf[node], glm::dmat4(1.0)});
        if (inverseBind.components == 16)
            for (glm::length_t i = 0; i < 16; ++i)
                joint.jointFromMesh[i / 4][i % 4] = inverseBind.values[16 * j + i];
    }
    return joints;
}

std::vector<glm::dmat4> skinMatrices(const GltfDocument& document, int skin,
                                     const std::vector<Joint>& joints,
                                     const std::vector<glm::dmat4>& worldFromNode) {
    const tinygltf::Skin& source = document.model->skins[skin];
    std::vector<glm::dmat4> matrices;
    for (std::size_t j = 0; j < joints.size(); ++j)
        matrices.push_back(worldFromNode[source.joints[j]] * joints[j].jointFromMesh);
    return matrices;
}

void requireJoints(const GltfDocument& document, const Primitive& primitive, std::size_t joints) {
    for (const Influence& influence : primitive.influences.all)
        if (influence.joint >= joints)
            throw InputError(document.where("JOINTS_0") + " names joint " +
                             std::to_string(influence.joint) + ", but the skin has " +
                             std::to_string(joints) + ".");
}

glm::dmat4 skinMatrixOf(const Primitive& primitive, std::size_t vertex,
                        const std::vector<glm::dmat4>& matrices) {
    glm::dmat4 blended(0.0);
    const auto influences = primitive.influences.of(vertex);
    for (const Influence& influence : influences)
        blended += static_cast<double>(influence.weight) * matrices[influence.joint];
    return blended / totalWeight(influences);
}

} // namespace edgeshade
