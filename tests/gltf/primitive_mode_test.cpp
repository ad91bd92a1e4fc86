#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

constexpr int pointsMode = 0, lineStripMode = 3, stripMode = 5, fanMode = 6;

Scene sceneWithIndices(int (*add)(GltfBuilder&, const std::vector<std::uint32_t>&)) {
    GltfBuilder gltf;
    Shape shape = tetrahedron();
    const std::vector<std::uint32_t> indices = std::exchange(shape.indices, {});
    gltf.addShapeNode(shape, {{"indices", add(gltf, indices)}});
    return sceneOf(gltf);
}

template <class T>
int addIndicesAs(GltfBuilder& gltf, const std::vector<std::uint32_t>& indices) {
    return gltf.addIndices<T>(indices);
}

Scene sceneWithMode(const std::vector<glm::vec3>& positions, int mode,
                    const std::vector<std::uint32_t>& indices = {}) {
    GltfBuilder gltf;
    gltf.addShapeNode({positions, {}, {}, indices}, {{"mode", mode}});
    return sceneOf(gltf);
}

Scene sceneWithTriangles(const std::vector<glm::vec3>& positions,
                         const std::vector<std::uint32_t>& indices) {
    GltfBuilder gltf;
    gltf.addShapeNode({positions, {}, {}, indices});
    return sceneOf(gltf);
}

} // namespace

TEST(PrimitiveMode, IndicesOfEveryWidthGiveTheSameTriangles) {
    const auto expected = worldTriangles(sceneWithIndices(addIndicesAs<std::uint32_t>));
    ASSERT_EQ(expected.size(), 4u);
    expectSameTriangles(worldTriangles(sceneWithIndices(addIndicesAs<std::uint16_t>)), expected);
    expectSameTriangles(worldTriangles(sceneWithIndices(addIndicesAs<std::uint8_t>)), expected);
}

TEST(PrimitiveMode, WithoutIndicesVerticesAreTakenInTheirOrder) {
    const Shape shape = tetrahedron();
    Shape spelled;
    for (const std::uint32_t index : shape.indices)
        spelled.positions.push_back(shape.positions[index]);
    GltfBuilder gltf;
    gltf.addShapeNode(spelled);
    expectSameTriangles(worldTriangles(sceneOf(gltf)),
                        worldTriangles(sceneWithTriangles(shape.positions, shape.indices)));
}

TEST(PrimitiveMode, AStripKeepsTheOrientationOfItsFirstTriangle) {
    const auto expected =
        worldTriangles(sceneWithTriangles(zigzag(), {0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}));
    const auto actual = worldTriangles(sceneWithMode(zigzag(), stripMode));
    expectSameTriangles(actual, expected);
    for (const WorldTriangle& triangle : actual)
        EXPECT_EQ(outside(triangle).z, -1.0);
}

TEST(PrimitiveMode, AnIndexedStripFollowsItsIndices) {
    expectSameTriangles(worldTriangles(sceneWithMode(zigzag(), stripMode, {1, 0, 3, 2})),
                        worldTriangles(sceneWithTriangles(zigzag(), {1, 0, 3, 0, 2, 3})));
}

TEST(PrimitiveMode, AFanTurnsAroundItsFirstVertex) {
    const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto actual = worldTriangles(sceneWithMode(positions, fanMode));
    expectSameTriangles(actual, worldTriangles(sceneWithTriangles(positions, {0, 1, 2, 0, 2, 3})));
    for (const WorldTriangle& triangle : actual)
        EXPECT_EQ(outside(triangle).z, 1.0);
}

TEST(PrimitiveMode, TooFewVerticesForATriangleGiveNone) {
    EXPECT_EQ(sceneWithMode({{0, 0, 0}, {1, 0, 0}}, stripMode).triangleCount(), 0u);
    EXPECT_EQ(sceneWithMode({{0, 0, 0}, {1, 0, 0}}, fanMode).triangleCount(), 0u);
}

TEST(PrimitiveMode, PointsAndLinesAreSkippedWithOneWarning) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    gltf.addShapeNode({zigzag(), {}, {}, {}}, {{"mode", pointsMode}});
    gltf.addShapeNode({zigzag(), {}, {}, {}}, {{"mode", lineStripMode}});
    gltf.addShapeNode({zigzag(), {}, {}, {}}, {{"mode", pointsMode}});
    const Scene scene = sceneOf(gltf);
    EXPECT_EQ(scene.triangleCount(), 4u);
    EXPECT_EQ(scene.warnings.sentences().size(), 1u);
    EXPECT_EQ(warningsWith(scene, "lines"), 1u);
}

TEST(PrimitiveMode, WithoutNormalsTrianglesAreFlat) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    for (const WorldTriangle& triangle : worldTriangles(sceneOf(gltf)))
        for (const Corner& corner : triangle)
            EXPECT_LT(glm::distance(glm::dvec3(corner.normal), outside(triangle)), 1e-6);
}

TEST(PrimitiveMode, NormalsOfTheFileAreKept) {
    Shape shape = tetrahedron();
    for (const glm::vec3& position : shape.positions)
        shape.normals.push_back(glm::normalize(position - glm::vec3(0.25f)));
    GltfBuilder gltf;
    gltf.addShapeNode(shape);
    for (const WorldTriangle& triangle : worldTriangles(sceneOf(gltf)))
        for (const Corner& corner : triangle)
            EXPECT_LT(glm::distance(corner.normal,
                                    glm::normalize(glm::vec3(corner.position) - glm::vec3(0.25f))),
                      1e-6f);
}

TEST(PrimitiveMode, EveryPrimitiveOfAMeshCounts) {
    GltfBuilder gltf;
    Json first = gltf.primitiveOf(tetrahedron());
    Json second = gltf.primitiveOf(box(glm::vec3(3.0f)));
    gltf.addNode({{"mesh", gltf.addMesh(Json::array({first, second}))}});
    EXPECT_EQ(sceneOf(gltf).triangleCount(), 16u);
}

} // namespace edgeshade::test
