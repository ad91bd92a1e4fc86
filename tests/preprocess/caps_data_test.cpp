#include "preprocess/volumes/published/caps_data.hpp"

#include "tests/support/record_multiplicity.hpp"
#include "tests/support/tiny_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

using Vectors = std::vector<glm::vec4>;

} // namespace

TEST(CapsData, CornersAreAscendingInEveryRotationAndWinding) {
    const std::vector<std::uint32_t> ascending = {0, 1, 2};
    std::vector<std::uint32_t> indices = ascending;
    do {
        const CapsData caps = buildCaps(build({{{1, 0, 0}, {2, 1, 0}, {3, 0, 0}}, indices}).mesh);
        EXPECT_EQ(caps.records, (Vectors{{1, 0, 0, 0}, {2, 1, 0, 0}, {3, 0, 0, 0}}));
    } while (std::next_permutation(indices.begin(), indices.end()));
}

TEST(CapsData, OneRecordATriangleInTheirOrder) {
    const Built built = build(tJunction());
    const CapsData caps = buildCaps(built.mesh);
    ASSERT_EQ(caps.recordCount(), 3u);
    // A D C, A M E, M E C
    EXPECT_EQ(caps.records, (Vectors{{0, 0, 0, 0},
                                     {1, -1, 0, 0},
                                     {2, 0, 0, 0},
                                     {0, 0, 0, 0},
                                     {1, 0, 0, 0},
                                     {1, 1, 0, 0},
                                     {1, 0, 0, 0},
                                     {1, 1, 0, 0},
                                     {2, 0, 0, 0}}));
}

TEST(CapsData, SignIsOneSeenCounterClockwise) {
    // A -> B -> C is clockwise from above.
    const CapsData caps = buildCaps(build({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2}}).mesh);
    using shader_arithmetic::ReferenceEdge;
    EXPECT_EQ(capSign<ReferenceEdge>(capsRecord(caps, 0), {0, 0, 5, 1}), -1.0f);
    EXPECT_EQ(capSign<ReferenceEdge>(capsRecord(caps, 0), {0, 0, -1, 0}), 1.0f);
    EXPECT_EQ(capSign<ReferenceEdge>(capsRecord(caps, 0), {4, 9, 0, 1}), 0.0f);
}

TEST(CapsData, ExpandedHasVertexInA) {
    const CapsData caps = buildCaps(build(tJunction()).mesh);
    const auto expanded = expandCaps(caps, 0, 3);
    ASSERT_EQ(expanded.size() * sizeof(glm::vec4), 3u * 288u);
    std::size_t at = 0;
    for (std::size_t r = 0; r < 3; ++r)
        for (int v = 0; v < 6; ++v, at += 3) {
            const auto record = capsRecord(caps, r);
            EXPECT_EQ(expanded[at], glm::vec4(glm::vec3(record[0]), static_cast<float>(v)));
            EXPECT_EQ(expanded[at + 1], record[1]);
            EXPECT_EQ(expanded[at + 2], record[2]);
        }
}

TEST(CapsData, ExpandedInPartsIsExpandedAtOnce) {
    const CapsData caps = buildCaps(build(cube()).mesh);
    Vectors parts = expandCaps(caps, 0, 5);
    const Vectors rest = expandCaps(caps, 5, 7);
    parts.insert(parts.end(), rest.begin(), rest.end());
    EXPECT_EQ(parts, expandCaps(caps, 0, 12));
}

} // namespace edgeshade::test
