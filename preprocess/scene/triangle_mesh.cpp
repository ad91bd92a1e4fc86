#include "preprocess/scene/triangle_mesh.hpp"

#include <cmath>
#include <string>

namespace edgeshade {

TriangleMesh triangleMesh(std::span<const float> positions,
                          std::span<const std::uint32_t> indices) {
    if (positions.size() % 3 != 0)
        throw InputError("A mesh has " + std::to_string(positions.size()) +
                         " position numbers, which is not three per vertex.");
    if (indices.size() % 3 != 0)
        throw InputError("A mesh has " + std::to_string(indices.size()) +
                         " indices, which is not three per triangle.");
    TriangleMesh mesh;
    const std::size_t vertices = positions.size() / 3;
    mesh.positions.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        glm::vec3& position = mesh.positions.emplace_back();
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const float value = positions[3 * i + static_cast<std::size_t>(axis)];
            if (!std::isfinite(value))
                throw InputError("Position " + std::to_string(i) +
                                 " of a mesh has a number that is not finite.");
            position[axis] = value + 0.0f; // no -0
        }
    }
    for (const std::uint32_t index : indices)
        if (index >= vertices)
            throw InputError("A mesh has the index " + std::to_string(index) + ", but " +
                             std::to_string(vertices) + " vertices.");
    mesh.indices.assign(indices.begin(), indices.end());
    return mesh;
}

} // namespace edgeshade
