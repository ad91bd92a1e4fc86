#include "tests/support/scene_builder.hpp"

namespace edgeshade::test {

SceneBuilder::SceneBuilder() {
    scene_.batches.emplace_back();
    material(Material());
}

SceneBuilder& SceneBuilder::material(const Material& material) {
    scene_.materials.push_back(material);
    geometry().groups.push_back(
        {scene_.materials.size() - 1, static_cast<std::uint32_t>(geometry().indices.size()), 0});
    return *this;
}

SceneBuilder& SceneBuilder::triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 cross = glm::cross(b - a, c - a);
    const float length = glm::length(cross);
    for (const glm::vec3& corner : {a, b, c}) {
        geometry().indices.push_back(static_cast<std::uint32_t>(geometry().positions.size()));
        geometry().positions.push_back(corner + 0.0f);
        geometry().normals.push_back(length > 0.0f ? cross / length : glm::vec3(0.0f));
        geometry().texcoords.emplace_back(0.0f);
        geometry().colors.emplace_back(1.0f);
    }
    geometry().groups.back().indexCount += 3;
    return *this;
}

SceneBuilder& SceneBuilder::quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                                 const glm::vec3& d) {
    return triangle(a, b, c).triangle(a, c, d);
}

SceneBuilder& SceneBuilder::box(const glm::vec3& low, const glm::vec3& high) {
    const auto corner = [&](int i) {
        return glm::vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    constexpr std::array<std::array<int, 4>, 6> faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& face : faces)
        quad(corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3]));
    return *this;
}

SceneBuilder& SceneBuilder::floor(float half, float y) {
    return quad({-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
}

SceneBuilder& SceneBuilder::placedBy(const glm::dmat4& worldFromBatch) {
    batch().worldFromBatch = worldFromBatch;
    return *this;
}

SceneBuilder yard() {
    return SceneBuilder()
        .floor(5)
        .box({-2, 0.5f, -1}, {-1, 2, 0})
        .box({0.5f, 0.25f, 0.5f}, {1.5f, 1, 2})
        .quad({-0.5f, 1, 0}, {0.5f, 1.2f, 0}, {0.4f, 2, 0.3f}, {-0.5f, 2, 0.1f})
        .triangle({2, 0.1f, -2}, {3, 0.1f, -2}, {2.5f, 2.5f, -1.5f});
}

} // namespace edgeshade::test
