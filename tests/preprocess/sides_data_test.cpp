#include "preprocess/volumes/published/sides_data.hpp"

#include "shaders_es2/record_layout.glsl"
#include "tests/support/record_multiplicity.hpp"
#include "tests/support/tiny_meshes.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

constexpr auto absent = static_cast<float>(ORDER_ABSENT);
constexpr auto first = static_cast<float>(ORDER_OPPOSITE_FIRST);
constexpr auto between = static_cast<float>(ORDER_OPPOSITE_BETWEEN);
constexpr auto last = static_cast<float>(ORDER_OPPOSITE_LAST);

using Vectors = std::vector<glm::vec4>;

SidesData sidesOf(const Soup& soup, int maxMultiplicity) {
    const Built built = build(soup);
    return buildSides(built.mesh.positions, built.edges, maxMultiplicity);
}

/// Number of opposite vertices in the record.
int held(std::span<const glm::vec4> record) {
    int count = 0;
    for (const glm::vec4& opposite : record.subspan(2))
        count += opposite.w != absent;
    return count;
}

} // namespace

TEST(SidesData, OrderSaysWhereTheOppositeStands) {
    // With 1 < 2 < 3 on the line, the vertex opposite (1,2) is last, opposite (1,3) between,
    // opposite (2,3) first.
    const Soup soup{{{1, 0, 0}, {2, 1, 0}, {3, 0, 0}}, {2, 0, 1}};
    EXPECT_EQ(sidesOf(soup, 1).records, (Vectors{{1, 0, 0, 0},
                                                 {2, 1, 0, 0},
                                                 {3, 0, 0, last},
                                                 {1, 0, 0, 0},
                                                 {3, 0, 0, 0},
                                                 {2, 1, 0, between},
                                                 {2, 1, 0, 0},
                                                 {3, 0, 0, 0},
                                                 {1, 0, 0, first}}));
}

TEST(SidesData, PlacesLeftOverAreAbsent) {
    const Soup soup{{{1, 0, 0}, {2, 1, 0}, {3, 0, 0}}, {0, 1, 2}};
    const SidesData sides = sidesOf(soup, 3);
    ASSERT_EQ(sides.vectorsPerRecord(), 5u);
    ASSERT_EQ(sides.recordCount(), 3u);
    EXPECT_EQ(
        Vectors(sides.records.begin(), sides.records.begin() + 5),
        (Vectors{
            {1, 0, 0, 0}, {2, 1, 0, 0}, {3, 0, 0, last}, {0, 0, 0, absent}, {0, 0, 0, absent}}));
}

TEST(SidesData, RecordMultiplicityIsTheLargestCountWithinOneToFive) {
    const std::vector<std::pair<std::uint32_t, int>> expected = {
        {0, 1}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 5}, {128, 5}, {0xFFFFFFFFu, 5}};
    for (const auto& [largest, multiplicity] : expected)
        EXPECT_EQ(recordMultiplicityFor(largest), multiplicity) << largest;
    EXPECT_EQ(LARGEST_RECORD_MULTIPLICITY, 5);
}

TEST(SidesData, AnEdgeWithMoreOppositesIsSplit) {
    // The spine's 128 triangles take 25 records of five and one of three; the other 256 edges take
    // one each.
    const SidesData sides = build(fan(128)).sides;
    EXPECT_EQ(sides.maxMultiplicity, 5);
    EXPECT_EQ(sides.recordCount(), 26u + 256u);
    for (std::size_t r = 0; r < 26; ++r) {
        const auto record = sidesRecord(sides, r);
        EXPECT_EQ(pointOf(record[0]), (Point{0, 0, 0}));
        EXPECT_EQ(pointOf(record[1]), (Point{0, 0, 1}));
        EXPECT_EQ(held(record), r < 25 ? 5 : 3);
    }
    for (std::size_t r = 26; r < sides.recordCount(); ++r)
        EXPECT_EQ(held(sidesRecord(sides, r)), 1);
}

TEST(SidesData, RecordsOfASplitEdgeHaveMultiplicitiesOfTheirOwn) {
    // All pages face this sun: 5 + ... + 5 + 3.
    const SidesData sides = build(fan(128)).sides;
    for (std::size_t r = 0; r < 26; ++r)
        EXPECT_EQ(recordMultiplicity<shader_arithmetic::ReferenceEdge>(sidesRecord(sides, r),
                                                                       {0, 1, 0, 0}),
                  r < 25 ? 5.0f : 3.0f);
}

TEST(SidesData, SumsDoNotDependOnTheRecordsSize) {
    for (const Soup& soup : {cube(), fin(), fan(128), moebiusStrip()})
        for (int maxMultiplicity = 1; maxMultiplicity <= 5; ++maxMultiplicity)
            for (const glm::vec4 light : {glm::vec4(3, 5, 7, 1), glm::vec4(1, 31.5, 0.5, 1),
                                          glm::vec4(0, 1, 0, 0), glm::vec4(0.5, 0.5, 0.5, 1)})
                EXPECT_EQ(silhouetteOf<shader_arithmetic::ReferenceEdge>(
                              sidesOf(soup, maxMultiplicity), light),
                          silhouetteOf<shader_arithmetic::ReferenceEdge>(build(soup).sides, light));
}

TEST(SidesData, RecordCountIsWhatIsEmitted) {
    for (const Soup& soup : {Soup{}, cube(), fin(), fan(1), fan(5), fan(6), fan(10), fan(128)})
        for (int maxMultiplicity = 1; maxMultiplicity <= 5; ++maxMultiplicity)
            EXPECT_EQ(recordCountFor(build(soup).edges, maxMultiplicity),
                      sidesOf(soup, maxMultiplicity).recordCount());
}

TEST(SidesData, ExpandedHasVertexInAAndSideInB) {
    const SidesData sides = build(fin()).sides; // three opposite vertices per record
    const auto expanded = expandSides(sides, 0, sides.recordCount());
    ASSERT_EQ(sides.maxMultiplicity, 3);
    ASSERT_EQ(expanded.size(), sides.recordCount() * 3 * 6 * 5);
    std::size_t at = 0;
    for (std::size_t r = 0; r < sides.recordCount(); ++r)
        for (int side = 0; side < 3; ++side)
            for (int v = 0; v < 6; ++v, at += 5) {
                const auto record = sidesRecord(sides, r);
                EXPECT_EQ(expanded[at], glm::vec4(glm::vec3(record[0]), static_cast<float>(v)));
                EXPECT_EQ(expanded[at + 1],
                          glm::vec4(glm::vec3(record[1]), static_cast<float>(side)));
                for (std::size_t i = 2; i < 5; ++i)
                    EXPECT_EQ(expanded[at + i], record[i]);
            }
}

TEST(SidesData, ExpandedIsThePublishedSize) {
    // e * maxMult * 6 * (2 + maxMult) * 16 bytes (thesis, 6.2.6).
    for (int maxMultiplicity = 1; maxMultiplicity <= 5; ++maxMultiplicity) {
        const SidesData sides = sidesOf(cube(), maxMultiplicity);
        const auto m = static_cast<std::size_t>(maxMultiplicity);
        EXPECT_EQ(expandSides(sides, 0, sides.recordCount()).size() * sizeof(glm::vec4),
                  sides.recordCount() * m * 6 * (2 + m) * 16);
    }
}

TEST(SidesData, ExpandedInPartsIsExpandedAtOnce) {
    const SidesData sides = build(fan(128)).sides;
    Vectors parts = expandSides(sides, 0, 100);
    for (const std::size_t start : {100u, 182u}) {
        const Vectors part = expandSides(sides, start, start == 100 ? 82 : 100);
        parts.insert(parts.end(), part.begin(), part.end());
    }
    EXPECT_EQ(parts, expandSides(sides, 0, sides.recordCount()));
    EXPECT_TRUE(expandSides(sides, 7, 0).empty());
}

} // namespace edgeshade::test
