#include "preprocess/gltf/accessor.hpp"
#include "preprocess/gltf/gltf_reading.hpp"

#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

std::vector<float> floatsOf(const GltfBuilder& gltf, int accessor) {
    return readFloats(parseGltf(gltf.glb(), "test.glb"), accessor, "test").values;
}

/// The accessor's `sparse` member, which puts `values` at `places`.
template <class Place>
Json sparseOf(GltfBuilder& gltf, const std::vector<Place>& places,
              const std::vector<float>& values) {
    const int indexView = gltf.addView(bytesOf(places));
    const int valueView = gltf.addView(bytesOf(values));
    return {{"count", places.size()},
            {"indices", {{"bufferView", indexView}, {"componentType", componentTypeOf<Place>}}},
            {"values", {{"bufferView", valueView}}}};
}

template <class T>
std::vector<float> readNormalized(const std::vector<T>& values) {
    GltfBuilder gltf;
    return floatsOf(gltf, gltf.addArray(values, 1, {{"normalized", true}}));
}

} // namespace

TEST(Accessor, SparseValuesReplaceThoseOfTheBaseView) {
    GltfBuilder gltf;
    const Json sparse = sparseOf<std::uint16_t>(gltf, {1, 3}, {10.0f, 30.0f});
    const int accessor = gltf.addArray<float>({0, 1, 2, 3, 4}, 1, {{"sparse", sparse}});
    EXPECT_EQ(floatsOf(gltf, accessor), (std::vector<float>{0, 10, 2, 30, 4}));
}

TEST(Accessor, SparseWithoutABaseViewStartsFromZeros) {
    GltfBuilder gltf;
    const Json sparse = sparseOf<std::uint8_t>(gltf, {0, 2}, {5.0f, 6.0f, 7.0f, 8.0f});
    const int accessor =
        gltf.addAccessor(-1, componentTypeOf<float>, 3, "VEC2", {{"sparse", sparse}});
    EXPECT_EQ(floatsOf(gltf, accessor), (std::vector<float>{5, 6, 0, 0, 7, 8}));
}

TEST(Accessor, SparseIndicesMayBe32BitWide) {
    GltfBuilder gltf;
    const Json sparse = sparseOf<std::uint32_t>(gltf, {2}, {9.0f});
    const int accessor =
        gltf.addAccessor(-1, componentTypeOf<float>, 3, "SCALAR", {{"sparse", sparse}});
    EXPECT_EQ(floatsOf(gltf, accessor), (std::vector<float>{0, 0, 9}));
}

TEST(Accessor, AttributesMayShareAnInterleavedView) {
    const Shape shape = box(glm::vec3(1.0f, 2.0f, 3.0f));
    std::vector<float> interleaved;
    for (std::size_t i = 0; i < shape.positions.size(); ++i)
        for (const float value :
             {shape.positions[i].x, shape.positions[i].y, shape.positions[i].z, shape.normals[i].x,
              shape.normals[i].y, shape.normals[i].z, shape.texcoords[i].x, shape.texcoords[i].y})
            interleaved.push_back(value);

    GltfBuilder gltf;
    const int view = gltf.addView(bytesOf(interleaved), 32);
    const auto add = [&](const char* type, int offset) {
        return gltf.addAccessor(view, componentTypeOf<float>, shape.positions.size(), type,
                                {{"byteOffset", offset}});
    };
    const Json attributes = {
        {"POSITION", add("VEC3", 0)}, {"NORMAL", add("VEC3", 12)}, {"TEXCOORD_0", add("VEC2", 24)}};
    gltf.addNode(
        {{"mesh", gltf.addMesh({{"attributes", attributes},
                                {"indices", gltf.addIndices<std::uint8_t>(shape.indices)}})}});

    GltfBuilder separate;
    separate.addShapeNode(shape);
    expectSameTriangles(worldTriangles(sceneOf(gltf)), worldTriangles(sceneOf(separate)));
}

TEST(Accessor, NormalizedIntegersAreFractionsOfTheirLargestValue) {
    EXPECT_EQ(readNormalized<std::uint8_t>({0, 51, 255}), (std::vector<float>{0.0f, 0.2f, 1.0f}));
    EXPECT_EQ(readNormalized<std::uint16_t>({0, 13107, 65535}),
              (std::vector<float>{0.0f, 0.2f, 1.0f}));
    EXPECT_EQ(readNormalized<std::int8_t>({-127, 0, 127}), (std::vector<float>{-1.0f, 0.0f, 1.0f}));
    EXPECT_EQ(readNormalized<std::int16_t>({-32767, 0, 32767}),
              (std::vector<float>{-1.0f, 0.0f, 1.0f}));
}

TEST(Accessor, TheMostNegativeNormalizedIntegerIsMinusOne) {
    EXPECT_EQ(readNormalized<std::int8_t>({-128}), std::vector<float>{-1.0f});
    EXPECT_EQ(readNormalized<std::int16_t>({-32768}), std::vector<float>{-1.0f});
}

TEST(Accessor, IntegersThatAreNotNormalizedKeepTheirValue) {
    GltfBuilder gltf;
    EXPECT_EQ(floatsOf(gltf, gltf.addArray<std::int16_t>({-32768, 7, 32767}, 1)),
              (std::vector<float>{-32768, 7, 32767}));
    EXPECT_EQ(floatsOf(gltf, gltf.addArray<std::uint8_t>({0, 200}, 1)),
              (std::vector<float>{0, 200}));
}

TEST(Accessor, QuantizedPositionsAreScaledByTheirNode) {
    // KHR_mesh_quantization: 16-bit positions, 8-bit normalized normals, the node scales them back.
    const Shape shape = box(glm::vec3(1.0f, 2.0f, 3.0f));
    std::vector<std::int16_t> positions;
    std::vector<std::int8_t> normals;
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
        for (glm::length_t c = 0; c < 3; ++c) {
            positions.push_back(static_cast<std::int16_t>(shape.positions[i][c] * 1024.0f));
            normals.push_back(static_cast<std::int8_t>(shape.normals[i][c] * 127.0f));
        }
        positions.push_back(0); // vertex attributes are aligned to four bytes
        normals.push_back(0);
    }
    GltfBuilder gltf;
    gltf.useExtension("KHR_mesh_quantization");
    const std::size_t count = shape.positions.size();
    const int positionAccessor = gltf.addAccessor(gltf.addView(bytesOf(positions), 8),
                                                  componentTypeOf<std::int16_t>, count, "VEC3");
    const int normalAccessor =
        gltf.addAccessor(gltf.addView(bytesOf(normals), 4), componentTypeOf<std::int8_t>, count,
                         "VEC3", {{"normalized", true}});
    const int texcoordAccessor = gltf.addVectors(shape.texcoords);
    const int mesh = gltf.addMesh({{"attributes",
                                    {{"POSITION", positionAccessor},
                                     {"NORMAL", normalAccessor},
                                     {"TEXCOORD_0", texcoordAccessor}}},
                                   {"indices", gltf.addIndices<std::uint16_t>(shape.indices)}});
    gltf.addNode({{"mesh", mesh}, {"scale", {1.0 / 1024, 1.0 / 1024, 1.0 / 1024}}});

    GltfBuilder plain;
    plain.addShapeNode(shape);
    expectSameTriangles(worldTriangles(sceneOf(gltf)), worldTriangles(sceneOf(plain)));
}

} // namespace edgeshade::test
