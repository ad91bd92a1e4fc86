#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/layers/chain_paths.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/hard_lights.hpp"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace edgeshade {
namespace {

using test::Random;

/// The bits of a place.
std::array<std::uint32_t, 3> bitsOf(const glm::vec3& place) {
    std::array<std::uint32_t, 3> bits{};
    std::memcpy(bits.data(), &place, sizeof(place));
    return bits;
}

/// Finds out which places have which numbers.
struct Numbered {
    std::map<std::array<std::uint32_t, 3>, std::set<std::uint32_t>> ofPlace;
    std::map<std::uint32_t, std::set<std::array<std::uint32_t, 3>>> places;

    template <class Record>
    void add(const std::vector<Record>& records, const std::vector<EndNumbers>& ends) {
        for (std::size_t i = 0; i < records.size(); ++i)
            for (const auto& [place, number] :
                 {std::pair(records[i].a, ends[i][0]), std::pair(records[i].b, ends[i][1])}) {
                ofPlace[bitsOf(place)].insert(number);
                places[number].insert(bitsOf(place));
            }
    }
};

PlanePairShadow recordsOf(const test::Soup& soup) {
    CasterMesh mesh;
    mesh.welded = weld(soup.positions, soup.indices);
    mesh.groups = {{0, 0, static_cast<std::uint32_t>(mesh.welded.triangles.size())}};
    return buildPlanePairs(mesh, buildEdges(mesh.welded), {Material()});
}

TEST(EdgeVertices, WithOneNumberAreOnePlace) {
    for (const test::Soup& soup :
         {test::hillyGrid(8000), test::manyBoxes(4000), test::tangle(3000), test::Soup{}}) {
        const PlanePairShadow shadow = recordsOf(soup);
        const EdgeVertices vertices(shadow);
        ASSERT_EQ(vertices.pairs.size(), shadow.pairs.size());
        ASSERT_EQ(vertices.singles.size(), shadow.singles.size());
        Numbered numbered;
        numbered.add(shadow.pairs, vertices.pairs);
        numbered.add(shadow.singles, vertices.singles);
        for (const auto& [number, places] : numbered.places) {
            EXPECT_EQ(places.size(), 1u);
            ASSERT_LT(number, vertices.places.size());
            EXPECT_EQ(bitsOf(vertices.places[number]), *places.begin());
        }
        EXPECT_EQ(numbered.places.size(), vertices.places.size());
        EXPECT_LE(vertices.places.size(), 1.3 * static_cast<double>(numbered.ofPlace.size()));
    }
}

// Places may differ in a last bit, or in a zero's sign.
TEST(EdgeVertices, TellPlacesApartBitByBit) {
    PlanePairShadow shadow;
    const float next = std::nextafter(1.0f, 2.0f);
    for (const glm::vec3& b : {glm::vec3(1, 2, 3), glm::vec3(next, 2, 3), glm::vec3(1, 2, -0.0f),
                               glm::vec3(1, 2, 0.0f), glm::vec3(2, 1, 3), glm::vec3(1, 2, 3)})
        shadow.singles.push_back({glm::vec3(0.0f), b, glm::vec4(0.0f)});
    ShadowCluster cluster;
    cluster.singles = {0, 6};
    shadow.clusters = {cluster};
    const EdgeVertices vertices(shadow);
    EXPECT_EQ(vertices.places.size(), 6u);
    EXPECT_EQ(vertices.singles[0], vertices.singles[5]);
    for (std::size_t i = 1; i < 5; ++i) {
        EXPECT_EQ(vertices.singles[i][0], vertices.singles[0][0]);
        EXPECT_NE(vertices.singles[i][1], vertices.singles[0][1]) << i;
    }
}

// A deforming batch keeps its numbers, and each pose has places of its own.
TEST(EdgeVertices, OfAPoseAreAtItsPlaces) {
    PlanePairShadow shadow = recordsOf(test::hillyGrid(800));
    const EdgeVertices rest(shadow);
    auto vertices = std::make_shared<RecordVertices>();
    vertices->inBatch.resize(rest.places.size());
    vertices->pairs = rest.pairs;
    vertices->singles = rest.singles;
    shadow.vertices = vertices;
    const auto pose = [](auto& records) {
        for (auto& record : records)
            for (glm::vec3* end : {&record.a, &record.b})
                *end += glm::vec3(0.0f, end->x * end->z, 0.0f);
    };
    pose(shadow.pairs);
    pose(shadow.singles);
    ASSERT_FALSE(shadow.pairs.empty());
    ASSERT_FALSE(shadow.singles.empty());
    const EdgeVertices posed(shadow);
    EXPECT_EQ(posed.pairs, rest.pairs);
    EXPECT_EQ(posed.singles, rest.singles);
    for (std::size_t i = 0; i < shadow.pairs.size(); ++i) {
        EXPECT_EQ(posed.places[posed.pairs[i][0]], shadow.pairs[i].a);
        EXPECT_EQ(posed.places[posed.pairs[i][1]], shadow.pairs[i].b);
    }
    for (std::size_t i = 0; i < shadow.singles.size(); ++i) {
        EXPECT_EQ(posed.places[posed.singles[i][0]], shadow.singles[i].a);
        EXPECT_EQ(posed.places[posed.singles[i][1]], shadow.singles[i].b);
    }
}

TEST(EdgeVertices, TellPlacesOfOneColumnApart) {
    PlanePairShadow shadow;
    for (int i = 0; i < 500; ++i)
        shadow.singles.push_back({glm::vec3(1, 2, i), glm::vec3(1, 2, i + 500), glm::vec4(0.0f)});
    ShadowCluster cluster;
    cluster.singles = {0, 500};
    shadow.clusters = {cluster};
    EXPECT_EQ(EdgeVertices(shadow).places.size(), 1000u);
}

// Each vertex starts as many paths as weights above it exceed those below it.
TEST(ChainPaths, StartWhereMoreRisesThanComes) {
    Random random(71);
    ChainPaths paths;
    for (int round = 0; round < 200; ++round) {
        constexpr int vertices = 40;
        struct Segment {
            EndNumbers ends;
            int weight, starts = 0;
        };
        std::vector<Segment> segments;
        for (int i = random.below(120); i > 0; --i)
            segments.push_back({{static_cast<std::uint32_t>(random.below(vertices)),
                                 static_cast<std::uint32_t>(random.below(vertices))},
                                random.below(7) - 3});
        paths.begin(vertices, segments.size());
        const std::size_t half = segments.size() / 2;
        for (const auto& [first, end] :
             {std::pair(std::size_t{0}, half), std::pair(half, segments.size())}) {
            ChainPaths::Adding adding(paths);
            for (std::size_t i = first; i < end; ++i)
                adding.add(segments[i].ends[0], segments[i].ends[1], segments[i].weight, i);
        }
        paths.findStarts([&](std::size_t i, int starts) { segments[i].starts = starts; });
        std::vector<int> rising(vertices, 0), starts(vertices, 0), told(vertices, 0);
        for (const Segment& segment : segments) {
            rising[segment.ends[0]] += std::max(segment.weight, 0);
            rising[segment.ends[1]] -= std::max(segment.weight, 0);
            starts[segment.ends[0]] += segment.starts;
            told[segment.ends[0]] += segment.starts != 0;
            EXPECT_TRUE(segment.weight > 0 || segment.starts == 0);
        }
        for (std::size_t v = 0; v < vertices; ++v) {
            EXPECT_EQ(starts[v], std::max(rising[v], 0)) << round;
            EXPECT_LE(told[v], 1) << round;
        }
    }
}

} // namespace
} // namespace edgeshade
