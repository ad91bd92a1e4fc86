#include "preprocess/gltf/color_filter.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"
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

/// The same scene with its views compressed by KHR_meshopt_compression.
GltfBuilder underKhronosName(GltfBuilder gltf) {
    std::string text = gltf.json.dump();
    const std::string name = "EXT_meshopt_compression";
    for (std::size_t at; (at = text.find(name)) != std::string::npos;)
        text.replace(at, 3, "KHR");
    gltf.json = Json::parse(text);
    return gltf;
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

TEST(Meshopt, TheKhronosExtensionIsTheSame) {
    const Shape shape = boxWithoutTexcoords();
    expectSameTriangles(worldTriangles(sceneOf(underKhronosName(meshoptScene(shape)))),
                        plainTriangles(shape));
}

TEST(Meshopt, AFallbackNeedNotSayThatItIsOne) {
    const Shape shape = boxWithoutTexcoords();
    for (const bool khronos : {false, true}) {
        GltfBuilder gltf = meshoptScene(shape);
        if (khronos) gltf = underKhronosName(std::move(gltf));
        gltf.json["buffers"][1].erase("extensions");
        expectSameTriangles(worldTriangles(sceneOf(gltf)), plainTriangles(shape));
        expectSameTriangles(worldTriangles(sceneOf(packed(gltf.glb(), Encoding::none))),
                            plainTriangles(shape));
    }
}

TEST(Meshopt, ABufferThatIsNeededIsNoFallback) {
    GltfBuilder gltf = meshoptScene(boxWithoutTexcoords());
    gltf.json["buffers"][1].erase("extensions");
    gltf.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 4}});
    expectInputError([&] { sceneOf(gltf); }, {"buffers[1].uri is missing"});
}

TEST(Meshopt, ColoursAreUnpacked) {
    // Y, Co, Cg and alpha of 8 bits, then of 4 bits: each colour of n bits is share / (2^n - 1).
    const std::vector<std::uint8_t> bytes = {
        128, 0,  0,    255, // grey, opaque
        63,  63, 0xC1, 255, // Co 63, Cg -63: red 189, green 0, blue 63
        4,   2,  1,    12,  // of 4 bits: red 5, green 5, blue 1; alpha 4 of 3 bits
    };
    const Shape shape = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {}};
    const auto colorsOf = [&](const Bytes& filtered, std::size_t stride, int componentType) {
        GltfBuilder gltf;
        const int colors = gltf.addAccessor(addMeshoptVertices(gltf, filtered, stride, "COLOR"),
                                            componentType, 3, "VEC4", {{"normalized", true}});
        Json primitive = gltf.primitiveOf(shape);
        primitive["attributes"]["COLOR_0"] = colors;
        gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
        return sceneOf(underKhronosName(std::move(gltf))).batches.at(0).geometry->colors;
    };
    const std::vector<glm::vec4> expected = {
        {128, 128, 128, 255}, {189, 0, 63, 255}, {85, 85, 17, 136}};
    const auto narrow = colorsOf(bytes, 4, 5121);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT(glm::distance(narrow[i] * 255.0f, expected[i]), 1e-3f) << i;

    std::vector<std::int16_t> words;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        words.push_back(i == 6 ? static_cast<std::int16_t>(-63) : bytes[i]);
    const auto wide = colorsOf(bytesOf(words), 8, 5123);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT(glm::distance(wide[i] * 255.0f, expected[i]), 1e-2f) << i;
}

TEST(Meshopt, ColoursThatNoEncoderWritesAreSomeColours) {
    Bytes bytes(4 * 256);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(i * 37 + i / 5);
    bytes[3] = 0;
    decodeColorFilter(bytes, 4);
    decodeColorFilter(bytes, 8);
}

TEST(Meshopt, TheColourFilterIsTheKhronosExtensionsAlone) {
    GltfBuilder gltf = meshoptScene(boxWithoutTexcoords());
    addMeshoptVertices(gltf, Bytes(16), 4, "COLOR");
    expectInputError([&] { sceneOf(gltf); },
                     {"EXT_meshopt_compression.filter is 'COLOR' with byteStride 4"});
}

TEST(Meshopt, ANewerVertexCodecIsRefusedByName) {
    GltfBuilder gltf = underKhronosName(meshoptScene(boxWithoutTexcoords()));
    const Json& view = gltf.json["bufferViews"][0]["extensions"]["KHR_meshopt_compression"];
    gltf.binary[view["byteOffset"].get<std::size_t>()] = 0xA1;
    expectInputError([&] { sceneOf(gltf); }, {"bufferViews[0].extensions.KHR_meshopt_compression",
                                              "vertices of codec version 1", "only version 0"});
}

} // namespace edgeshade::test
