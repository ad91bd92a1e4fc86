#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

namespace edgeshade::test {
namespace {

Shape boxWithoutTexcoords() {
    Shape shape = box(glm::vec3(1.0f, 2.0f, 3.0f));
    shape.texcoords.clear();
    return shape;
}

std::vector<WorldTriangle> plainTriangles(const Shape& shape) {
    GltfBuilder plain;
    plain.addShapeNode(shape);
    return worldTriangles(sceneOf(plain));
}

} // namespace

TEST(Meshopt, VerticesAndTrianglesDecodeToTheSource) {
    const Shape shape = boxWithoutTexcoords();
    expectSameTriangles(worldTriangles(sceneOf(meshoptScene(shape))), plainTriangles(shape));
}

TEST(Meshopt, IndexSequencesKeepTheirOrder) {
    // A strip, so that the order matters.
    GltfBuilder gltf;
    const int indices = gltf.addAccessor(addMeshoptIndices(gltf, {0, 1, 2, 3, 4, 5}),
                                         componentTypeOf<std::uint16_t>, 6, "SCALAR");
    gltf.addShapeNode({zigzag(), {}, {}, {}}, {{"mode", 5}, {"indices", indices}});
    GltfBuilder plain;
    plain.addShapeNode({zigzag(), {}, {}, {}}, {{"mode", 5}});
    expectSameTriangles(worldTriangles(sceneOf(gltf)), worldTriangles(sceneOf(plain)));
}

TEST(Meshopt, OctahedralNormalsAreUnpacked) {
    const Shape shape = boxWithoutTexcoords();
    std::vector<float> source;
    for (const glm::vec3& normal : shape.normals)
        source.insert(source.end(), {normal.x, normal.y, normal.z, 0.0f});
    Bytes filtered(4 * shape.normals.size());
    meshopt_encodeFilterOct(filtered.data(), shape.normals.size(), 4, 8, source.data());

    GltfBuilder gltf = meshoptScene(shape);
    const int view = addMeshoptVertices(gltf, filtered, 4, "OCTAHEDRAL");
    gltf.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = gltf.addAccessor(
        view, componentTypeOf<std::int8_t>, shape.normals.size(), "VEC3", {{"normalized", true}});
    expectSameTriangles(worldTriangles(sceneOf(gltf)), plainTriangles(shape), 0.02);
}

TEST(Meshopt, ExponentialPositionsAreUnpacked) {
    const Shape shape = boxWithoutTexcoords();
    Bytes filtered(sizeof(glm::vec3) * shape.positions.size());
    meshopt_encodeFilterExp(filtered.data(), shape.positions.size(), 12, 15, &shape.positions[0].x);

    GltfBuilder gltf = meshoptScene(shape);
    const int view = addMeshoptVertices(gltf, filtered, 12, "EXPONENTIAL");
    gltf.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        gltf.addAccessor(view, componentTypeOf<float>, shape.positions.size(), "VEC3");
    expectSameTriangles(worldTriangles(sceneOf(gltf)), plainTriangles(shape), 1e-3);
}

TEST(Meshopt, AFallbackWithBytesIsNotNeeded) {
    const Shape shape = boxWithoutTexcoords();
    GltfBuilder gltf = meshoptScene(shape);
    const std::size_t length = gltf.json["buffers"][1]["byteLength"].get<std::size_t>();
    gltf.json["buffers"][1]["uri"] = dataUri(Bytes(length, 0xAB));
    expectSameTriangles(worldTriangles(sceneOf(gltf)), plainTriangles(shape));
}

} // namespace edgeshade::test
