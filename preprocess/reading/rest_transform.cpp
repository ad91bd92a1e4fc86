#include "preprocess/reading/rest_transform.hpp"

#include "preprocess/gltf/tinygltf_model.hpp"

#include <cmath>

namespace edgeshade {

NodeTransform restTransform(const tinygltf::Node& node) {
    NodeTransform rest;
    if (node.translation.size() == 3)
        rest.translation = {node.translation[0], node.translation[1], node.translation[2]};
    if (node.rotation.size() == 4)
        rest.rotation =
            glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (node.scale.size() == 3) rest.scale = {node.scale[0], node.scale[1], node.scale[2]};
    return rest;
}

bool hasMatrix(const tinygltf::Node& node) {
    return node.matrix.size() == 16;
}

glm::dmat4 restMatrix(const tinygltf::Node& node) {
    if (!hasMatrix(node)) return restTransform(node).matrix();
    glm::dmat4 matrix;
    for (glm::length_t i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = node.matrix[i];
    return matrix;
}

glm::dmat4 unflattenedRestMatrix(const tinygltf::Node& node) {
    return hasMatrix(node) ? unflattened(restMatrix(node)) : restTransform(node).unflattened();
}

std::optional<NodeTransform> partsOf(const glm::dmat4& matrix) {
    constexpr double tolerance = 1e-5; // for files that store floats
    NodeTransform parts;
    parts.translation = glm::dvec3(matrix[3]);
    glm::dmat3 turn(matrix);
    if (!(glm::determinant(turn) > 0.0)) return std::nullopt;
    for (glm::length_t c = 0; c < 3; ++c) {
        parts.scale[c] = glm::length(turn[c]);
        turn[c] /= parts.scale[c];
    }
    for (glm::length_t c = 0; c < 3; ++c)
        if (!(std::abs(glm::dot(turn[c], turn[(c + 1) % 3])) < tolerance)) return std::nullopt;
    parts.rotation = glm::normalize(glm::quat_cast(turn));
    return parts;
}

} // namespace edgeshade
