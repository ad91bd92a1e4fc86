#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_triangles.hpp"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

constexpr const char* extensionName = "KHR_draco_mesh_compression";

/// One attribute as it goes into the encoder.
template <class Vector>
void addAttribute(draco::TriangleSoupMeshBuilder& builder, const Shape& shape,
                  draco::GeometryAttribute::Type type, const std::vector<Vector>& values) {
    const int id = builder.AddAttribute(type, static_cast<std::int8_t>(Vector::length()),
                                        draco::DT_FLOAT32);
    for (std::uint32_t i = 0; i < shape.indices.size(); i += 3)
        builder.SetAttributeValuesForFace(id, draco::FaceIndex(i / 3),
                                          &values[shape.indices[i]][0],
                                          &values[shape.indices[i + 1]][0],
                                          &values[shape.indices[i + 2]][0]);
}

/// POSITION has id 0, NORMAL 1, TEXCOORD_0 2.
Bytes dracoEncoded(const Shape& shape) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(shape.indices.size() / 3));
    addAttribute(builder, shape, draco::GeometryAttribute::POSITION, shape.positions);
    addAttribute(builder, shape, draco::GeometryAttribute::NORMAL, shape.normals);
    addAttribute(builder, shape, draco::GeometryAttribute::TEX_COORD, shape.texcoords);
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 10);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    return Bytes(buffer.data(), buffer.data() + buffer.size());
}

/// A primitive that has its data in Draco alone.
Json dracoPrimitive(GltfBuilder& gltf, const Shape& shape) {
    const int view = gltf.addView(dracoEncoded(shape));
    const auto claim = [&](const char* type, std::size_t count, int componentType) {
        return gltf.addAccessor(-1, componentType, count, type);
    };
    const std::size_t vertices = shape.positions.size();
    return {{"attributes",
             {{"POSITION", claim("VEC3", vertices, componentTypeOf<float>)},
              {"NORMAL", claim("VEC3", vertices, componentTypeOf<float>)},
              {"TEXCOORD_0", claim("VEC2", vertices, componentTypeOf<float>)}}},
            {"indices", claim("SCALAR", shape.indices.size(), componentTypeOf<std::uint16_t>)},
            {"extensions",
             {{extensionName,
               {{"bufferView", view},
                {"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}}}}}}};
}

/// Positions of 14 bits over 6 units, normals of 10 bits, texture coordinates of 12.
constexpr double quantisation = 0.01;

} // namespace

TEST(Draco, DecodesToTheSourceWithinItsQuantisation) {
    const Shape shape = box(glm::vec3(1.0f, 2.0f, 3.0f));
    GltfBuilder compressed;
    compressed.useExtension(extensionName);
    compressed.addNode({{"mesh", compressed.addMesh(dracoPrimitive(compressed, shape))}});
    GltfBuilder plain;
    plain.addShapeNode(shape);
    expectSameTriangles(worldTriangles(sceneOf(compressed)), worldTriangles(sceneOf(plain)),
                        quantisation);
}

TEST(Draco, EveryPrimitiveHasItsOwnStream) {
    const Shape first = box(glm::vec3(1.0f)), second = box(glm::vec3(0.5f, 2.0f, 3.0f));
    GltfBuilder compressed;
    compressed.useExtension(extensionName);
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
    gltf.useExtension(extensionName);
    Json primitive = dracoPrimitive(gltf, box(glm::vec3(1.0f)));
    primitive["attributes"].erase("NORMAL");
    primitive["extensions"][extensionName]["attributes"].erase("NORMAL");
    gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
    for (const WorldTriangle& triangle : worldTriangles(sceneOf(gltf)))
        EXPECT_LT(glm::distance(glm::dvec3(triangle[0].normal), outside(triangle)), 1e-6);
}

TEST(Draco, CompressedPiecesMeetWhereTheirGridsAgree) {
    // Two neighbours with the same bounds decode their common corners to the same floats.
    GltfBuilder gltf;
    gltf.useExtension(extensionName);
    const Shape shape = box(glm::vec3(1.0f, 2.0f, 3.0f));
    gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, shape))}});
    gltf.addNode({{"mesh", gltf.addMesh(dracoPrimitive(gltf, shape))}});
    const auto triangles = worldTriangles(sceneOf(gltf));
    const std::vector<WorldTriangle> first(triangles.begin(), triangles.begin() + 12);
    expectSameTriangles({triangles.begin() + 12, triangles.end()}, first);
}

} // namespace edgeshade::test
