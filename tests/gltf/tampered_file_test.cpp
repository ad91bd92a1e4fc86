#include "preprocess/base/error.hpp"
#include "preprocess/packing/edge_codec.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/packing.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace edgeshade::test {
namespace {

using Tamper = std::function<void(GlbParts&)>;

Json& extensionOf(GlbParts& parts) {
    return parts.json["extensions"][shadowExtensionName];
}
Json& batchOf(GlbParts& parts) {
    return extensionOf(parts)["batches"][0];
}

/// The bytes of the first element of the batch's `key`.
std::uint8_t* bytesAt(GlbParts& parts, const char* key) {
    return parts.binary.data() + parts.offsetOf(batchOf(parts)[key].get<int>());
}

void storeFloat(GlbParts& parts, const char* key, std::size_t element, float value) {
    std::memcpy(bytesAt(parts, key) + element * sizeof value, &value, sizeof value);
}

/// Expects that the packed scene is refused with a sentence that names the file and `words`.
void expectRefused(Encoding encoding, const Tamper& tamper,
                   std::initializer_list<const char*> words, const CasterSettings& settings = {}) {
    GlbParts parts(packed(variedScene().glb(), encoding, settings));
    EXPECT_NO_THROW(readBack(parts.glb()));
    tamper(parts);
    const Bytes glb = parts.glb();
    expectInputError([&] { readBack(glb); }, {"packed.glb", shadowExtensionName});
    expectInputError([&] { readBack(glb); }, words);
}

/// Lets the batch's `key` refer to other bytes, at the end of the buffer.
void replaceBytes(GlbParts& parts, const char* key, const Bytes& bytes) {
    Json& accessor = parts.json["accessors"][batchOf(parts)[key].get<int>()];
    Json& view = parts.json["bufferViews"][accessor["bufferView"].get<int>()];
    accessor["count"] = view["byteLength"] = bytes.size();
    view["byteOffset"] = parts.binary.size();
    parts.binary.insert(parts.binary.end(), bytes.begin(), bytes.end());
    parts.json["buffers"][0]["byteLength"] = parts.binary.size();
}

Bytes bytesOf(GlbParts& parts, const char* key) {
    const std::uint8_t* first = bytesAt(parts, key);
    const Json& accessor = parts.json["accessors"][batchOf(parts)[key].get<int>()];
    return {first, first + accessor["count"].get<std::size_t>()};
}

/// The first batch's edges: two boxes and a book.
EdgeList edgesOf(GlbParts& parts) {
    const EncodedEdges streams = {bytesOf(parts, "edgeVertices"), bytesOf(parts, "oppositeCounts"),
                                  bytesOf(parts, "oppositeVertices")};
    return decodeEdges(streams, batchOf(parts)["edgeCount"].get<std::size_t>(), 3 * (12 + 7), 17)
        .edges;
}

/// Expects that the packed scene is refused with changed edges.
void expectRefusedEdges(const std::function<void(EdgeList&)>& change,
                        std::initializer_list<const char*> words) {
    expectRefused(
        Encoding::indexed,
        [&](GlbParts& parts) {
            EdgeList list = edgesOf(parts);
            ASSERT_FALSE(list.edges.empty());
            change(list);
            const EncodedEdges encoded = encodeEdges(list);
            replaceBytes(parts, "edgeVertices", encoded.vertices);
            replaceBytes(parts, "oppositeCounts", encoded.counts);
            replaceBytes(parts, "oppositeVertices", encoded.opposites);
        },
        words);
}

void expectRefusedHeader(const char* key, const Json& value,
                         std::initializer_list<const char*> words) {
    for (const Encoding encoding : everyEncoding)
        expectRefused(
            encoding, [&](GlbParts& parts) { extensionOf(parts)[key] = value; }, words);
}

} // namespace

TEST(TamperedFile, ChangedPositionsAreNoticed) {
    for (const Encoding encoding : everyEncoding)
        expectRefused(
            encoding,
            [](GlbParts& parts) {
                const int accessor =
                    parts.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>();
                parts.binary[parts.offsetOf(accessor)] ^= 1;
            },
            {"batches[0].positionsHash", "changed after packing"});
}

TEST(TamperedFile, AChangedIndexIsNoticed) {
    expectRefused(Encoding::expanded,
                  [](GlbParts& parts) {
                      const int accessor =
                          parts.json["meshes"][0]["primitives"][0]["indices"].get<int>();
                      parts.binary[parts.offsetOf(accessor)] ^= 1;
                  },
                  {"positionsHash"});
}

TEST(TamperedFile, AMovedNodeIsNoticed) {
    expectRefused(Encoding::none,
                  [](GlbParts& parts) {
                      parts.json["nodes"][0]["translation"] = {0.0, 0.5, 0.0};
                  },
                  {"positionsHash"});
}

TEST(TamperedFile, ASurfaceThatStoppedCastingIsNoticed) {
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) { parts.json["materials"][0]["alphaMode"] = "BLEND"; },
                  {"positionsHash"});
}

TEST(TamperedFile, AHashThatIsNoTextIsRefused) {
    expectRefused(Encoding::none, [](GlbParts& parts) { batchOf(parts)["positionsHash"] = 5; }, {});
    expectRefused(Encoding::none, [](GlbParts& parts) { batchOf(parts).erase("positionsHash"); },
                  {"positionsHash"});
}

TEST(TamperedFile, AnotherVersionIsRefused) {
    expectRefusedHeader("version", 1, {".version is 1", "reads version 2"});
    expectRefusedHeader("version", 0, {".version is 0"});
    expectRefusedHeader("version", "2", {});
}

TEST(TamperedFile, AnUnknownEncodingIsRefused) {
    expectRefusedHeader("encoding", "zipped", {".encoding is 'zipped'"});
    expectRefusedHeader("encoding", 1, {});
}

TEST(TamperedFile, AMultiplicityOutOfRangeIsRefused) {
    expectRefusedHeader("maxMultiplicity", 0, {".maxMultiplicity is 0", "1 to 5"});
    expectRefusedHeader("maxMultiplicity", 6, {".maxMultiplicity is 6", "1 to 5"});
    expectRefusedHeader("maxMultiplicity", -1, {".maxMultiplicity is -1"});
    expectRefusedHeader("maxMultiplicity", nullptr, {});
}

TEST(TamperedFile, AnotherMultiplicityDoesNotFitTheRecords) {
    expectRefused(Encoding::expanded,
                  [](GlbParts& parts) { extensionOf(parts)["maxMultiplicity"] = 4; }, {".sides"});
}

TEST(TamperedFile, SettingsOfTheWrongKindAreRefused) {
    expectRefusedHeader("weldTolerance", -1.0, {".weldTolerance"});
    expectRefusedHeader("weldTolerance", "none", {});
    expectRefusedHeader("casterError", -1.0, {".casterError"});
    expectRefusedHeader("casterError", "none", {});
    expectRefusedHeader("flatTolerance", -1.0, {".flatTolerance"});
    expectRefusedHeader("flatTolerance", 45.0, {".flatTolerance is 45", "below 45"});
    expectRefusedHeader("castMasked", 7, {});
    expectRefusedHeader("batches", 7, {".batches"});
}

TEST(TamperedFile, AMissingKeyIsRefused) {
    for (const char* key : {"version", "encoding", "maxMultiplicity", "weldTolerance", "castMasked",
                            "casterError", "flatTolerance", "batches"}) {
        SCOPED_TRACE(key);
        expectRefused(Encoding::indexed, [&](GlbParts& parts) { extensionOf(parts).erase(key); },
                      {key});
    }
}

TEST(TamperedFile, AnExtensionThatIsNoObjectIsRefused) {
    expectRefused(Encoding::none, [](GlbParts& parts) { extensionOf(parts) = 5; }, {});
    expectRefused(Encoding::none, [](GlbParts& parts) { batchOf(parts) = "batch"; }, {});
}

TEST(TamperedFile, TooFewOrTooManyBatchesAreRefused) {
    for (const Encoding encoding : everyEncoding) {
        expectRefused(encoding, [](GlbParts& parts) { extensionOf(parts)["batches"].erase(2); },
                      {".batches has 2 entries", "3 batches"});
        expectRefused(
            encoding,
            [](GlbParts& parts) { extensionOf(parts)["batches"].push_back(batchOf(parts)); },
            {".batches has 4 entries", "3 batches"});
    }
}

TEST(TamperedFile, ABatchOfAnotherNodeIsRefused) {
    expectRefused(Encoding::none, [](GlbParts& parts) { batchOf(parts)["node"] = 2; },
                  {"batches[0].node is 2"});
}

TEST(TamperedFile, AMissingAccessorIsRefused) {
    for (const char* key : {"sides", "caps"})
        expectRefused(Encoding::expanded, [&](GlbParts& parts) { batchOf(parts).erase(key); },
                      {"batches[0].", key, "missing"});
    for (const char* key : {"edgeVertices", "oppositeCounts", "oppositeVertices"})
        expectRefused(Encoding::indexed, [&](GlbParts& parts) { batchOf(parts).erase(key); },
                      {"batches[0].", key, "missing"});
}

TEST(TamperedFile, AnAccessorOutOfRangeIsRefused) {
    for (const Json& index : {Json(999), Json(-1), Json(1.5), Json("0")}) {
        expectRefused(Encoding::expanded, [&](GlbParts& parts) { batchOf(parts)["caps"] = index; },
                      {"batches[0].caps"});
        expectRefused(Encoding::indexed,
                      [&](GlbParts& parts) { batchOf(parts)["edgeVertices"] = index; },
                      {"batches[0].edgeVertices"});
    }
}

TEST(TamperedFile, AnAccessorOfAnotherKindIsRefused) {
    expectRefused(Encoding::expanded,
                  [](GlbParts& parts) {
                      batchOf(parts)["sides"] =
                          parts.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
                  },
                  {"batches[0].sides"});
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) {
                      batchOf(parts)["oppositeCounts"] =
                          parts.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
                  },
                  {"batches[0].oppositeCounts"});
}

TEST(TamperedFile, AnUnknownOrderCodeIsRefused) {
    // The fourth component of the first opposite vertex.
    expectRefused(Encoding::expanded,
                  [](GlbParts& parts) { storeFloat(parts, "sides", 4 * 2 + 3, 7.0f); },
                  {"batches[0].sides", "7.0", "vector 2"});
    expectRefused(Encoding::expanded, [](GlbParts& parts) { storeFloat(parts, "sides", 3, 1.0f); },
                  {"batches[0].sides", "vector 0"});
}

TEST(TamperedFile, CapsWithAFourthComponentAreRefused) {
    expectRefused(Encoding::expanded, [](GlbParts& parts) { storeFloat(parts, "caps", 3, 1.0f); },
                  {"batches[0].caps"});
}

TEST(TamperedFile, NaNAndInfinityAreRefused) {
    for (const char* key : {"sides", "caps"})
        for (const float value :
             {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
            expectRefused(Encoding::expanded,
                          [&](GlbParts& parts) { storeFloat(parts, key, 5, value); },
                          {"batches[0].", key, "NaN"});
}

TEST(TamperedFile, TooFewRecordsAreRefused) {
    for (const char* key : {"sides", "caps"})
        expectRefused(Encoding::expanded,
                      [&](GlbParts& parts) {
                          Json& count =
                              parts.json["accessors"][batchOf(parts)[key].get<int>()]["count"];
                          count = count.get<int>() - 1;
                      },
                      {"batches[0].", key});
}

TEST(TamperedFile, AnEdgeOutOfRangeIsRefused) {
    expectRefusedEdges([](EdgeList& list) { list.edges[0].b = 0xFFFF; },
                       {".edgeVertices", "edge 0"});
    expectRefusedEdges([](EdgeList& list) { list.edges[3].a = list.edges[3].b; },
                       {".edgeVertices", "edge 3"});
}

TEST(TamperedFile, AnEdgeWhoseVerticesAreNotInOrderIsRefused) {
    expectRefusedEdges([](EdgeList& list) { std::swap(list.edges[0].a, list.edges[0].b); },
                       {".edgeVertices", "edge 0"});
}

TEST(TamperedFile, AnOppositeVertexOutOfRangeIsRefused) {
    expectRefusedEdges([](EdgeList& list) { list.opposites[0].vertex = 255; },
                       {".oppositeVertices", "edge 0"});
    expectRefusedEdges([](EdgeList& list) { list.opposites[0].vertex = 0xFFFFFFFF; },
                       {".oppositeVertices", "edge 0"});
}

TEST(TamperedFile, AnOppositeVertexOnItsOwnEdgeIsRefused) {
    expectRefusedEdges([](EdgeList& list) { list.opposites[0].vertex = list.edges[0].a; },
                       {".oppositeVertices", "edge 0"});
    expectRefusedEdges([](EdgeList& list) { list.opposites[0].vertex = list.edges[0].b; },
                       {".oppositeVertices", "edge 0"});
}

TEST(TamperedFile, EdgesOfFewerOrMoreOppositeVerticesThanThereAreAreRefused) {
    const auto replaceCounts = [](GlbParts& parts, std::uint32_t first) {
        EdgeList list = edgesOf(parts);
        std::vector<Opposite> all = list.opposites;
        list.opposites.resize(std::max<std::size_t>(all.size(), first + 100));
        list.edges[0].oppositeCount = first;
        const EncodedEdges encoded = encodeEdges(list);
        replaceBytes(parts, "oppositeCounts", encoded.counts);
    };
    for (const std::uint32_t first : {0u, 200u})
        expectRefused(Encoding::indexed, [&](GlbParts& parts) { replaceCounts(parts, first); },
                      {"batches[0].oppositeCounts"});
    // The other counts are then shifted by one.
    expectRefused(Encoding::indexed, [&](GlbParts& parts) { replaceCounts(parts, 1); },
                  {"batches[0]."});
}

TEST(TamperedFile, AnotherNumberOfEdgesIsRefused) {
    for (const Json& count : {Json(0), Json(-1), Json(1), Json(1000000000), Json("all")})
        expectRefused(Encoding::indexed,
                      [&](GlbParts& parts) { batchOf(parts)["edgeCount"] = count; },
                      {"batches[0]."});
    expectRefused(Encoding::indexed, [](GlbParts& parts) { batchOf(parts).erase("edgeCount"); },
                  {"batches[0].edgeCount", "missing"});
}

TEST(TamperedFile, BytesThatDoNotDecodeAreRefused) {
    for (const char* key : {"edgeVertices", "oppositeCounts", "oppositeVertices"}) {
        expectRefused(Encoding::indexed, [&](GlbParts& parts) { bytesAt(parts, key)[0] ^= 0x80; },
                      {"batches[0].", key, "does not decode"});
        for (const std::size_t size : {1, 7, 1000})
            expectRefused(Encoding::indexed,
                          [&](GlbParts& parts) { replaceBytes(parts, key, Bytes(size, 0xA0)); },
                          {"batches[0].", key});
        expectRefused(Encoding::indexed,
                      [&](GlbParts& parts) {
                          parts.json["accessors"][batchOf(parts)[key].get<int>()]["componentType"] =
                              5123;
                      },
                      {"batches[0]."});
    }
}

TEST(TamperedFile, AnyByteOfTheStreamsMayBeAnything) {
    // Data that still decode to edges are accepted; anything else is refused and nothing else
    // happens.
    const GlbParts sound(packed(variedScene().glb(), Encoding::indexed));
    std::size_t refused = 0, all = 0;
    for (const char* key : {"edgeVertices", "oppositeCounts", "oppositeVertices"}) {
        GlbParts parts = sound;
        const Json accessor = parts.json["accessors"][batchOf(parts)[key].get<int>()];
        for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i)
            for (const int change : {0x01, 0x10, 0x80, 0xFF}) {
                parts = sound;
                bytesAt(parts, key)[i] ^= static_cast<std::uint8_t>(change);
                ++all;
                try {
                    readBack(parts.glb());
                } catch (const InputError&) {
                    ++refused;
                }
            }
    }
    EXPECT_GT(refused, all / 4);
}

TEST(TamperedFile, SimplifiedCastersThatCanNotBeAreRefused) {
    const auto expect = [](const Tamper& tamper, std::initializer_list<const char*> words) {
        for (const Encoding encoding : everyEncoding)
            expectRefused(encoding, tamper, words, {0.0, false, 0.01});
    };
    expect([](GlbParts& parts) { bytesAt(parts, "simplifiedCasters")[0] = 0xFF; },
           {"batches[0].simplifiedCasters", "255", "vertices"});
    expect([](GlbParts& parts) { batchOf(parts).erase("simplifiedCasters"); },
           {"batches[0].simplifiedCasters", "missing"});
    expect([](GlbParts& parts) { batchOf(parts).erase("simplifiedTriangles"); },
           {"batches[0].simplifiedTriangles", "missing"});
    expect([](GlbParts& parts) { batchOf(parts)["simplifiedTriangles"] = -1; },
           {"batches[0].simplifiedTriangles"});
    expect(
        [](GlbParts& parts) {
            Json& triangles = batchOf(parts)["simplifiedTriangles"];
            triangles = triangles.get<int>() + 1;
        },
        {"batches[0].simplifiedCasters", "corners"});
    expect(
        [](GlbParts& parts) {
            Json& count =
                parts.json["accessors"][batchOf(parts)["simplifiedCasters"].get<int>()]["count"];
            count = count.get<int>() - 1;
        },
        {"batches[0].simplifiedCasters", "corners"});
    expect([](GlbParts& parts) { batchOf(parts)["simplifiedCasters"] = 999; },
           {"batches[0].simplifiedCasters"});
}

TEST(TamperedFile, ACutOffFileIsRefused) {
    for (const Encoding encoding : everyEncoding) {
        Bytes glb = packed(variedScene().glb(), encoding);
        glb.resize(glb.size() - 100);
        expectInputError([&] { readBack(glb); }, {"packed.glb", "cut off"});
    }
}

TEST(TamperedFile, ACutOffBufferIsRefused) {
    GlbParts parts(packed(variedScene().glb(), Encoding::expanded));
    parts.binary.resize(parts.binary.size() - 100);
    expectInputError([&] { readBack(parts.glb()); }, {"packed.glb", "buffers[0].byteLength"});
    parts.json["buffers"][0]["byteLength"] = parts.binary.size();
    expectInputError([&] { readBack(parts.glb()); }, {"packed.glb", "bufferViews"});
}

} // namespace edgeshade::test
