#pragma once

#include "preprocess/base/file_io.hpp"
#include "preprocess/scene/scene.hpp"

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace edgeshade::test {

class GltfBuilder;

/// One corner of a triangle, in the world.
struct Corner {
    glm::dvec3 position;
    glm::vec3 normal;
    glm::vec2 texcoord;
};
using WorldTriangle = std::array<Corner, 3>;

/// Reads and flattens an asset.
Scene sceneOf(const Bytes& asset);
Scene sceneOf(const GltfBuilder& builder);

/// Every triangle of the scene, in order.
std::vector<WorldTriangle> worldTriangles(const Scene& scene);

/// The geometric normal of unit length, which points outside.
glm::dvec3 outside(const WorldTriangle& triangle);

/// Number of the scene's warnings that contain `word`.
std::size_t warningsWith(const Scene& scene, const std::string& word);

/// Expects the same triangles in any order, with the same orientation and attributes, and each
/// corner's numbers within `tolerance`.
void expectSameTriangles(const std::vector<WorldTriangle>& actual,
                         const std::vector<WorldTriangle>& expected, double tolerance = 0.0);

} // namespace edgeshade::test
