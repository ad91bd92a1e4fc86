#include "tests/support/draco_encoding.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// Positions of 14 bits over 6 units, normals of 10 bits, texture coordinates of 12.
constexpr double quantisation = 0.01;

} // namespace

TEST(Draco, DecodesToTheSourceWithinItsQuantisation) {
    const Shape shape = box(glm::vec3(1.0f, 2.0f, 3.0f));
    GltfBuilder compressed;
    compressed.useExtension(dracoExtension);
    compressed.addNode({{"mesh", compressed.addMesh(dracoPrimitive(compressed, shape))}});
    GltfBuilder plain;
    plain.addShapeNode(shape);
    expectSameTriangles(worldTriangles(sceneOf(compressed)), worldTriangles(sceneOf(plain)),
                        quantisation);
}

TEST(Draco, EveryPrimitiveHasItsOwnStream) {
    const Shape first = box(glm::vec3(1.0f)), second = box(glm::vec3(0.5f, 2.0f, 3.0f));
    GltfBuilder compressed;
    compressed.useExtension(dracoExtension);
    Json primitives =
        Json::array({dracoPrimitive(compressed, first), dracoPrimitive(compressed, second)});
    compressed.addNode({{"mesh", compressed.addMesh(primitives)}});
    GltfBuilder plain;
    primitives = Json::array({plain.primitiveOf(first), plain.primitiveOf(second)});
    plain.addNode({{"mesh", plain.addMesh(primitives)}});
    expectSameTriangles(worldTriangles(sceneOf(compressed)), worldTriangles(sceneOf(plain)),
                        quantisation);
}

TEST(Draco, AnAttributeThatIsNotCompressedComesFromItsAccessor) {
    GltfBuilder gltf;
    gltf.useExtension(dracoExtension);
    Json primitive = dracoPrimitive(gltf, box(glm::vec3(1.0f)));
    primitive["attributes"].erase("NORMAL");
    primitive["extensions"][dracoExtension]["attributes"].erase("NORMAL");
    gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
    for (const WorldTriangle& triangle : worldTriangles(sceneOf(gltf)))
        EXPECT_LT(glm::distance(glm::dvec3(triangle[0].normal), outside(triangle)), 1e-6);
}

TEST(Draco, CompressedPiecesMeetWhereTheirGridsAgree) {
    // Two neighbours with the same bounds decode their common corners to the same floats.
    GltfBuilder gltf;
    gltf.useExtension(dracoExtension);
    const Shape shape = box(glm::vec3(1.0f, 2.0f, 3.0f));
    gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, shape))}});
    gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, shape))}});
    const auto triangles = worldTriangles(sceneOf(gltf));
    const std::vector<WorldTriangle> first(triangles.begin(), triangles.begin() + 12);
    expectSameTriangles({triangles.begin() + 12, triangles.end()}, first);
}

} // namespace edgeshade::test
