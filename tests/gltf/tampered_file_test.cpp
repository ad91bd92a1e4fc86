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

/// Where the first element of the batch's `key` lies.
std::uint8_t* bytesAt(GlbParts& parts, const char* key) {
    return parts.binary.data() + parts.offsetOf(batchOf(parts)[key].get<int>());
}

void storeFloat(GlbParts& parts, const char* key, std::size_t element, float value) {
    std::memcpy(bytesAt(parts, key) + element * sizeof value, &value, sizeof value);
}

/// Expects that the packed scene is refused with a sentence that names the file and `words`.
void expectRefused(Encoding encoding, const Tamper& tamper,
                   std::initializer_list<const char*> words) {
    GlbParts parts(packed(variedScene().glb(), encoding));
    EXPECT_NO_THROW(readBack(parts.glb()));
    tamper(parts);
    const Bytes glb = parts.glb();
    expectInputError([&] { readBack(glb); }, {"packed.glb", shadowExtensionName});
    expectInputError([&] { readBack(glb); }, words);
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
    expectRefusedHeader("version", 2, {".version is 2", "reads version 1"});
    expectRefusedHeader("version", 0, {".version is 0"});
    expectRefusedHeader("version", "1", {});
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
    expectRefusedHeader("castMasked", 7, {});
    expectRefusedHeader("batches", 7, {".batches"});
}

TEST(TamperedFile, AMissingKeyIsRefused) {
    for (const char* key :
         {"version", "encoding", "maxMultiplicity", "weldTolerance", "castMasked", "batches"}) {
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
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) { bytesAt(parts, "edgeVertices")[1] = 0xFF; },
                  {"batches[0].edgeVertices", "edge 0"});
}

TEST(TamperedFile, AnEdgeWhoseVerticesAreNotInOrderIsRefused) {
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) {
                      std::uint8_t* edge = bytesAt(parts, "edgeVertices");
                      std::swap(edge[0], edge[1]);
                  },
                  {"batches[0].edgeVertices", "edge 0"});
}

TEST(TamperedFile, AnOppositeVertexOutOfRangeIsRefused) {
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) { bytesAt(parts, "oppositeVertices")[0] = 0xFF; },
                  {"batches[0].oppositeVertices", "255"});
}

TEST(TamperedFile, AnOppositeVertexOnItsOwnEdgeIsRefused) {
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) {
                      bytesAt(parts, "oppositeVertices")[0] = bytesAt(parts, "edgeVertices")[0];
                  },
                  {"batches[0].oppositeVertices"});
}

TEST(TamperedFile, AnEdgeWithoutOppositeVerticesIsRefused) {
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) { bytesAt(parts, "oppositeCounts")[0] = 0; },
                  {"batches[0]."});
}

TEST(TamperedFile, MoreOppositeVerticesThanThereAreIsRefused) {
    expectRefused(Encoding::indexed,
                  [](GlbParts& parts) { bytesAt(parts, "oppositeCounts")[0] = 200; },
                  {"batches[0]."});
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
