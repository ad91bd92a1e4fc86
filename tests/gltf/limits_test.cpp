// Limits on files: each refuses quickly, in a sentence, and accepts a value at the limit.
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/mesh/weld.hpp"
#include "preprocess/reading/animation_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "tests/support/draco_encoding.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace edgeshade::test {
namespace {

const glm::vec3 one(1.0f);

Scene flattened(const Bytes& glb, const ReadingLimits& limits) {
    return flattenScene(parseGltf(glb, "test.glb", limits), 0.0);
}

ReadingLimits withMemory(std::uint64_t bytes) {
    ReadingLimits limits;
    limits.memoryBytes = bytes;
    return limits;
}

void expectRefused(const Bytes& glb, const ReadingLimits& limits,
                   std::initializer_list<const char*> words) {
    expectInputError([&] { flattened(glb, limits); }, words);
}

/// Peak memory of this process in bytes.
std::size_t peakBytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Expects a refusal within the usual limits that takes only a few megabytes.
void expectBombRefused(const Bytes& glb, std::initializer_list<const char*> words) {
    const std::size_t before = peakBytes();
    expectRefused(glb, {}, words);
    EXPECT_LT(peakBytes() - before, std::size_t{64} << 20);
}

/// A node for each of `count` uses of one mesh.
GltfBuilder repeated(const Shape& shape, int count) {
    GltfBuilder gltf;
    const int mesh = gltf.addShape(shape);
    for (int i = 0; i < count; ++i)
        gltf.addNode({{"mesh", mesh}});
    return gltf;
}

/// A chain of nodes below each other, the last with a mesh.
GltfBuilder chainOf(int depth) {
    GltfBuilder gltf;
    int node = gltf.addNode({{"mesh", gltf.addShape(tetrahedron())}}, depth == 1);
    for (int level = depth - 1; level > 0; --level)
        node = gltf.addNode({{"children", Json::array({node})}}, level == 1);
    return gltf;
}

} // namespace

TEST(Limits, AFileAsLargeAsAllowedIsRead) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const Bytes glb = gltf.glb();
    const auto path = folder.write("scene.glb", glb);
    ReadingLimits limits;
    limits.fileBytes = glb.size();
    EXPECT_NO_THROW(readGltf(path, limits));
    --limits.fileBytes;
    const std::string size = std::to_string(glb.size()), limit = std::to_string(limits.fileBytes);
    expectInputError([&] { readGltf(path, limits); },
                     {"scene.glb", size.c_str(), "limit for a file", limit.c_str()});
}

TEST(Limits, ExternalFilesAreAsLargeAtMost) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    folder.write("scene.bin", Bytes(100'000));
    const auto path = folder.write("scene.gltf", std::string_view(gltf.gltf("scene.bin")));
    ReadingLimits limits;
    limits.fileBytes = 50'000;
    expectInputError([&] { readGltf(path, limits); }, {"scene.bin", "100000", "50000"});
}

TEST(Limits, AFileWithoutEndIsNotReadToIt) {
    if (!std::filesystem::exists("/dev/zero")) GTEST_SKIP() << "there is no /dev/zero";
    expectInputError([] { readFile("/dev/zero", 1'000'000); }, {"/dev/zero", "1000000"});
}

TEST(Limits, OneFileOfManyBuffersCountsManyTimes) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    folder.write("scene.bin", Bytes(1'000'000));
    Json buffer = {{"uri", "scene.bin"}, {"byteLength", 1'000'000}};
    gltf.json["buffers"] = std::vector<Json>(100, buffer);
    const auto path = folder.write("scene.gltf", std::string_view(gltf.gltf("scene.bin")));
    EXPECT_NO_THROW(readGltf(path));
    expectInputError([&] { readGltf(path, withMemory(20'000'000)); },
                     {"buffers[1", "1000000 bytes of memory", "20000000"});
}

TEST(Limits, TrianglesCountForEveryNode) {
    const Bytes glb = repeated(tetrahedron(), 5).glb();
    ReadingLimits limits;
    limits.triangles = 20;
    EXPECT_EQ(flattened(glb, limits).triangleCount(), 20u);
    limits.triangles = 19;
    expectRefused(glb, limits, {"nodes[4]", "20 triangles", "19"});
}

TEST(Limits, AMeshOfManyNodesIsNotRepeatedBeyondMemory) {
    expectRefused(repeated(box(one), 5000).glb(), withMemory(16 << 20),
                  {"nodes[", "bytes of memory", "16777216"});
}

TEST(Limits, VerticesThatNoTriangleUsesCountToo) {
    GltfBuilder gltf;
    Shape shape = box(one);
    shape.positions.resize(100'000);
    shape.normals.resize(100'000, {0, 1, 0});
    shape.texcoords.clear();
    shape.indices.resize(3);
    const int mesh = gltf.addShape(shape);
    for (int i = 0; i < 100; ++i)
        gltf.addNode({{"mesh", mesh}});
    expectRefused(gltf.glb(), withMemory(64 << 20), {"nodes[", "bytes of memory"});
}

TEST(Limits, Nodes) {
    const Bytes glb = repeated(tetrahedron(), 5).glb();
    ReadingLimits limits;
    limits.nodes = 5;
    EXPECT_NO_THROW(flattened(glb, limits));
    limits.nodes = 4;
    expectRefused(glb, limits, {"nodes", "5", "limit", "4"});
}

TEST(Limits, LevelsOfNodes) {
    const Bytes glb = chainOf(20).glb();
    ReadingLimits limits;
    limits.nodeDepth = 20;
    EXPECT_EQ(flattened(glb, limits).triangleCount(), 4u);
    limits.nodeDepth = 19;
    expectRefused(glb, limits, {"nodes[0]", "level 20", "19"});
}

TEST(Limits, ChainsOfNodesFarBelowTheStackAreWalked) {
    ReadingLimits limits;
    limits.nodeDepth = 100'000;
    EXPECT_EQ(flattened(chainOf(100'000).glb(), limits).triangleCount(), 4u);
}

TEST(Limits, MembersOfAJsonObject) {
    // Objects are searched linearly: without a limit this would take a million squared steps.
    std::string json = R"({"asset":{"version":"2.0"},"extras":{"a":0)";
    for (int i = 0; i < 1'000'000; ++i)
        json += ",\"" + std::to_string(i) + "\":0";
    json += "}}";
    expectInputError([&] { parseGltf(Bytes(json.begin(), json.end()), "test.gltf"); },
                     {"test.gltf", "object", "1000"});
}

TEST(Limits, ValuesOfJson) {
    std::string json = R"({"asset":{"version":"2.0"},"extras":[0)";
    for (int i = 0; i < 1'000'000; ++i)
        json += ",0";
    json += "]}";
    const Bytes bytes(json.begin(), json.end());
    EXPECT_NO_THROW(parseGltf(bytes, "test.gltf"));
    expectInputError([&] { parseGltf(bytes, "test.gltf", withMemory(100'000'000)); },
                     {"test.gltf", "JSON", "100000000"});
}

TEST(Limits, ItemsThatAreSmallInJsonAndLargeInMemory) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    gltf.json["materials"] = std::vector<Json>(20'000, Json::object());
    EXPECT_NO_THROW(flattened(gltf.glb(), {}));
    expectRefused(gltf.glb(), withMemory(40'000'000), {"materials", "40000000"});
}

TEST(Bombs, AccessorsWithoutDataAreCounted) {
    GltfBuilder gltf;
    Json primitives = Json::array();
    for (int i = 0; i < 500; ++i)
        primitives.push_back(
            {{"attributes",
              {{"POSITION", gltf.addAccessor(-1, componentTypeOf<float>, 16'000'000, "VEC3")}}}});
    gltf.addNode({{"mesh", gltf.addMesh(primitives)}});
    expectRefused(gltf.glb(), withMemory(100'000'000), {"meshes[0].primitives[0]", "192000000"});
}

TEST(Bombs, MorphTargetsAreCounted) {
    GltfBuilder gltf;
    Json primitive = gltf.primitiveOf(tetrahedron());
    const int zeros = gltf.addAccessor(-1, componentTypeOf<float>, 4, "VEC3");
    primitive["targets"] = std::vector<Json>(100'000, {{"POSITION", zeros}});
    const int mesh = gltf.addMesh(primitive);
    gltf.json["meshes"][mesh]["weights"] = std::vector<double>(100'000, 0.5);
    gltf.addNode({{"mesh", mesh}});
    const Bytes glb = gltf.glb();
    EXPECT_NO_THROW(flattened(glb, {}));
    const GltfDocument document = parseGltf(glb, "test.glb");
    expectRefused(glb, withMemory(document.memory.taken() + 1'000'000),
                  {"targets[", "bytes of memory"});
}

TEST(Bombs, SkinsAreReadOnceForAllNodes) {
    GltfBuilder gltf;
    Json primitive = gltf.primitiveOf(tetrahedron());
    primitive["attributes"]["JOINTS_0"] = gltf.addArray(std::vector<std::uint8_t>(16, 0), 4);
    primitive["attributes"]["WEIGHTS_0"] = gltf.addArray(std::vector<float>(16, 0.25f), 4);
    const int mesh = gltf.addMesh(primitive);
    for (int i = 0; i < 10'000; ++i)
        gltf.addNode({{"mesh", mesh}, {"skin", 0}});
    gltf.json["skins"] = {{{"joints", std::vector<int>(10'000, 0)}}};
    // One skin per node would be 12.8 GB.
    const std::size_t before = peakBytes();
    EXPECT_EQ(flattened(gltf.glb(), {}).triangleCount(), 40'000u);
    EXPECT_LT(peakBytes() - before, std::size_t{512} << 20);
}

TEST(Bombs, MeshoptViewsOfTheSameBytesAreCounted) {
    GltfBuilder gltf;
    const Bytes zeros(1 << 20, 0);
    addMeshoptVertices(gltf, zeros, 4);
    const Json view = gltf.json["bufferViews"][0];
    for (int i = 0; i < 100; ++i)
        gltf.json["bufferViews"].push_back(view);
    expectRefused(gltf.glb(), withMemory(32 << 20), {"bufferViews[", "count", "33554432"});
}

namespace {

/// The box in Draco, with its stream changed by `change`.
Bytes dracoBomb(const std::function<void(Bytes&)>& change) {
    GltfBuilder gltf;
    gltf.useExtension(dracoExtension);
    Json primitive = dracoPrimitive(gltf, box(one));
    Bytes stream = dracoEncoded(box(one));
    change(stream);
    primitive["extensions"][dracoExtension]["bufferView"] = gltf.addView(stream);
    gltf.addNode({{"mesh", gltf.addMesh(primitive)}});
    return gltf.glb();
}

/// A 32-bit number in Draco's variable-length encoding.
Bytes shortened(std::uint32_t value) {
    Bytes bytes;
    for (; value >= 128; value >>= 7)
        bytes.push_back(static_cast<std::uint8_t>(value | 128));
    bytes.push_back(static_cast<std::uint8_t>(value));
    return bytes;
}

/// The header of a stream of version 2.2: 1 for edgebreaker, 0 for sequential.
Bytes dracoHead(std::uint8_t method) {
    return {'D', 'R', 'A', 'C', 'O', 2, 2, 1, method, 0, 0};
}

void append(Bytes& bytes, const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

} // namespace

TEST(Bombs, DracoTrianglesThatCantBeThere) {
    expectBombRefused(dracoBomb([](Bytes& stream) {
                          stream = dracoHead(1);
                          stream.push_back(0); // traversal
                          append(stream, shortened(1'000'000));
                          append(stream, shortened(300'000'000));
                          stream.push_back(0);
                          append(stream, shortened(300'000'000));
                          append(stream, shortened(0));
                          stream.resize(200);
                      }),
                      {dracoExtension, "300000000 triangles", "200 bytes"});
}

TEST(Bombs, DracoVerticesThatCantBeThere) {
    expectBombRefused(dracoBomb([](Bytes& stream) {
                          stream = dracoHead(0);
                          append(stream, shortened(0));
                          append(stream, shortened(4'000'000'000));
                          stream.push_back(1);
                          stream.resize(200);
                      }),
                      {dracoExtension, "4000000000 vertices", "200 bytes"});
}

TEST(Bombs, DracoWithinWhatBytesCanHoldIsCounted) {
    const Bytes glb = dracoBomb([](Bytes& stream) {
        stream = dracoHead(1);
        stream.push_back(0);
        append(stream, shortened(500'000));
        append(stream, shortened(1'000'000));
        stream.push_back(255); // attributes with their own connectivity
        append(stream, shortened(1'000'000));
        append(stream, shortened(0));
        stream.resize(2000);
    });
    expectBombRefused(glb, {dracoExtension}); // the stream itself is invalid
    expectRefused(glb, withMemory(std::uint64_t{1} << 30), {dracoExtension, "bytes of memory"});
    ReadingLimits limits;
    limits.triangles = 999'999;
    expectRefused(glb, limits, {dracoExtension, "1000000 triangles", "999999"});
}

TEST(Bombs, ValuesOfAnimationsAreCounted) {
    GltfBuilder gltf;
    const int node = gltf.addShapeNode(tetrahedron());
    std::vector<float> times(100'000);
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i] = static_cast<float>(i);
    const int input = gltf.addArray(times, 1);
    Json channels = Json::array(), samplers = Json::array();
    for (const char* path : {"translation", "scale"}) {
        const int output = gltf.addAccessor(-1, componentTypeOf<float>, times.size(), "VEC3");
        channels.push_back(
            {{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
        samplers.push_back({{"input", input}, {"output", output}});
    }
    gltf.json["animations"] = {{{"channels", channels}, {"samplers", samplers}}};
    Warnings warnings;
    EXPECT_TRUE(readAnimation(parseGltf(gltf.glb(), "test.glb"), warnings));
    EXPECT_TRUE(warnings.sentences().empty());
    const auto read =
        readAnimation(parseGltf(gltf.glb(), "test.glb", withMemory(3'000'000)), warnings);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->motions.at(node).translation);
    EXPECT_FALSE(read->motions.at(node).scale);
    ASSERT_EQ(warnings.sentences().size(), 1u);
    const std::string& warning = warnings.sentences()[0];
    for (const char* words :
         {"animations[0].samplers[1].output", "1200000", "3000000", "the channel is left out"})
        EXPECT_NE(warning.find(words), std::string::npos) << warning;
}

TEST(Bombs, ATinyWeldToleranceFarOutFillsNoCell) {
    // Comparing each with each would take hours.
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 200'000; ++i)
        positions.emplace_back(1e6f + static_cast<float>(i), -5.0f, static_cast<float>(i % 3));
    const std::vector<glm::vec3> before = positions;
    snapPositions(positions, 1e-300);
    EXPECT_EQ(positions, before);
}

} // namespace edgeshade::test
