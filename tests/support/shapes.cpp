#include "tests/support/shapes.hpp"

#include <cmath>

namespace edgeshade::test {

Shape box(const glm::vec3& half) {
    Shape shape;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f), across(0.0f), up(0.0f);
            normal[axis] = side;
            across[(axis + 1) % 3] = side;
            up[(axis + 2) % 3] = 1.0f;
            const auto base = static_cast<std::uint32_t>(shape.positions.size());
            for (const glm::vec2 corner :
                 {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
                shape.positions.push_back(half * (normal + corner.x * across + corner.y * up));
                shape.normals.push_back(normal);
                shape.texcoords.push_back(0.5f * (corner + 1.0f));
            }
            for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
                shape.indices.push_back(base + corner);
        }
    return shape;
}

Shape tetrahedron() {
    Shape shape;
    shape.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    shape.indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    return shape;
}

Shape book(int count) {
    Shape shape;
    shape.positions = {{0, 0, 0}, {0, 1, 0}};
    for (int page = 0; page < count; ++page) {
        const float angle = 6.0f * static_cast<float>(page) / static_cast<float>(count);
        shape.positions.emplace_back(std::cos(angle), 0.5f, std::sin(angle));
        shape.indices.insert(shape.indices.end(), {0, 1, static_cast<std::uint32_t>(page + 2)});
    }
    return shape;
}

std::vector<glm::vec3> zigzag() {
    return {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}};
}

} // namespace edgeshade::test
