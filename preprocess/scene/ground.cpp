#include "preprocess/scene/ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace edgeshade {
namespace {

constexpr int segments = 96;
constexpr double inner = 2.0, outer = 6.0; // radii, in radii of the scene's ball
constexpr double sunk = 2e-4;              // as a share of the ball's radius: surfaces at y = low
                                           // stay above the ground

constexpr double lowest = 0.1;  // share of the height
constexpr double covered = 0.5; // share of the area seen from above

Material groundMaterial(const Ground& ground) {
    Material material;
    material.ground = ground.material;
    material.baseColorFactor = glm::vec4(ground.color, 1.0f);
    material.metallic = 0.0f;
    return material;
}

void addRing(Geometry& geometry, double radius, float alpha) {
    for (int i = 0; i < segments; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / segments;
        geometry.positions.emplace_back(radius * std::cos(angle), 0.0f, -radius * std::sin(angle));
        geometry.colors.emplace_back(1.0f, 1.0f, 1.0f, alpha);
    }
}

/// The corners are counter-clockwise as seen from above.
void addTriangle(Geometry& geometry, int a, int b, int c) {
    for (const int corner : {a, b, c})
        geometry.indices.push_back(static_cast<std::uint32_t>(corner));
}

/// Twice the area of the triangle as seen from above, negative if it faces down.
double areaFromAbove(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::cross(b - a, c - a).y;
}

} // namespace

bool addGround(Scene& scene, const Ground& ground) {
    const Box box = worldBounds(scene);
    if (box.empty()) return false;
    const double radius = std::max(0.5 * box.diagonal(), 1e-9);
    Batch batch;
    batch.ground = true;
    glm::dvec3 origin = box.center();
    origin.y = box.low.y - sunk * radius;
    batch.worldFromBatch = batch.nodeFromBatch = glm::translate(glm::dmat4(1.0), origin);
    Geometry& geometry = batch.geometry.edit();
    geometry.positions.emplace_back(0.0f);
    geometry.colors.emplace_back(1.0f);
    addRing(geometry, inner * radius, 1.0f);
    addRing(geometry, outer * radius, 0.0f);
    for (int i = 0; i < segments; ++i) {
        const int here = 1 + i, next = 1 + (i + 1) % segments;
        addTriangle(geometry, 0, here, next);
        addTriangle(geometry, here, here + segments, next + segments);
        addTriangle(geometry, here, next + segments, next);
    }
    geometry.normals.assign(geometry.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
    geometry.texcoords.assign(geometry.positions.size(), glm::vec2(0.0f));
    geometry.groups.push_back(
        {scene.materials.size(), 0, static_cast<std::uint32_t>(geometry.indices.size())});
    scene.materials.push_back(groundMaterial(ground));
    scene.batches.push_back(std::move(batch));
    return true;
}

std::optional<std::size_t> groundMaterialOf(const Scene& scene) {
    for (const Batch& batch : scene.batches)
        if (batch.ground) return batch.geometry->groups.front().material;
    return std::nullopt;
}

void setGround(Scene& scene, const Ground& ground) {
    scene.materials[*groundMaterialOf(scene)] = groundMaterial(ground);
}

bool hasFloor(const Scene& scene) {
    const Box box = worldBounds(scene);
    if (box.empty()) return false;
    const glm::dvec3 size = box.high - box.low;
    const double top = box.low.y + lowest * size.y;
    double area = 0.0; // twice the area of floors
    for (const Batch& batch : scene.batches) {
        if (batch.ground) continue;
        const auto corner = [&](std::size_t i) {
            return glm::dvec3(
                batch.worldFromBatch *
                glm::dvec4(batch.geometry->positions[batch.geometry->indices[i]], 1.0));
        };
        for (std::size_t i = 0; i < batch.geometry->indices.size(); i += 3) {
            const glm::dvec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
            const double seen = (batch.isMirrored() ? -1.0 : 1.0) * areaFromAbove(a, b, c);
            if (std::max({a.y, b.y, c.y}) <= top) area += std::max(seen, 0.0);
        }
    }
    return area >= covered * 2.0 * size.x * size.z;
}

} // namespace edgeshade
