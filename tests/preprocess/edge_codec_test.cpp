#include "preprocess/packing/edge_codec.hpp"

#include "tests/support/small_soups.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace edgeshade {
namespace {

void expectSame(const EdgeList& decoded, const EdgeList& original) {
    EXPECT_EQ(decoded.edges, original.edges);
    ASSERT_EQ(decoded.opposites.size(), original.opposites.size());
    for (std::size_t i = 0; i < original.opposites.size(); ++i)
        EXPECT_EQ(decoded.opposites[i].vertex, original.opposites[i].vertex);
}

std::string hexOf(const Bytes& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes)
        for (const int digit : {byte >> 4, byte & 15})
            text += "0123456789abcdef"[digit];
    return text;
}

DecodedEdges decodedAgain(const test::Built& built) {
    return decodeEdges(encodeEdges(built.edges), built.edges.edges.size(),
                       built.edges.opposites.size(), built.mesh.positions.size());
}

} // namespace

TEST(EdgeCodec, TinyMeshesComeBack) {
    for (const test::Soup& soup : {test::cube(), test::openBox(), test::fin(), test::fan(128),
                                   test::moebiusStrip(), test::tJunction()}) {
        const test::Built built = test::build(soup);
        const DecodedEdges decoded = decodedAgain(built);
        EXPECT_FALSE(decoded.fault);
        expectSame(decoded.edges, built.edges);
    }
}

RC_GTEST_PROP(EdgeCodec, SoupsComeBack, ()) {
    const test::Built built = test::build(test::latticeSoup());
    if (built.edges.edges.empty()) RC_SUCCEED("no edges");
    const DecodedEdges decoded = decodedAgain(built);
    RC_ASSERT(!decoded.fault);
    expectSame(decoded.edges, built.edges);
}

TEST(EdgeCodec, TheStreamsOfTheCubeAreThese) {
    // Files that were packed once must stay readable.
    const test::Built cube = test::build(test::cube());
    const EncodedEdges streams = encodeEdges(cube.edges);
    EXPECT_EQ(hexOf(streams.vertices),
              "a005002426648000000000000006024229244961252250000000000000000000"
              "0000000000000000000000000000000000000000000000000001000000");
    EXPECT_EQ(hexOf(streams.counts),
              "a000000000000000000000000000000000000000000000000000000000000000"
              "0002000000");
    EXPECT_EQ(hexOf(streams.opposites),
              "a01a089ff0a125169f1a120f12d51e2926211a56f115fb000000120909000000"
              "0000000000000000000000000000000000000000000000000000000002000000");
}

TEST(EdgeCodec, OtherCountsAreFaults) {
    const test::Built cube = test::build(test::cube());
    const EncodedEdges streams = encodeEdges(cube.edges);
    const std::size_t edges = cube.edges.edges.size(), opposites = cube.edges.opposites.size();
    EXPECT_FALSE(decodeEdges(streams, edges, opposites, 8).fault);
    EXPECT_TRUE(decodeEdges(streams, edges, opposites, 7).fault);
    EXPECT_TRUE(decodeEdges(streams, edges + 300, opposites, 8).fault);
    EXPECT_EQ(decodeEdges(streams, edges, opposites - 1, 8).fault, EdgeStream::counts);
    EXPECT_TRUE(decodeEdges(streams, edges, opposites + 300, 8).fault);
    EXPECT_EQ(decodeEdges({}, edges, opposites, 8).fault, EdgeStream::vertices);
}

} // namespace edgeshade
