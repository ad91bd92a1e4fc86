// A mesh's records depend only on its triangles as sets of positions.
#include "preprocess/volumes/published/caps_data.hpp"
#include "tests/support/record_multiplicity.hpp"
#include "tests/support/small_soups.hpp"
#include "tests/support/tiny_meshes.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>

namespace edgeshade::test {
namespace {

/// The soup's triangles in another order, each rotated or mirrored.
Soup shuffled(const Soup& soup) {
    std::vector<std::vector<std::uint32_t>> triangles;
    for (std::size_t i = 0; i < soup.indices.size(); i += 3)
        triangles.push_back({soup.indices[i], soup.indices[i + 1], soup.indices[i + 2]});
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    for (std::size_t i = triangles.size(); i > 1; --i)
        std::swap(triangles[i - 1],
                  triangles[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    Soup result{soup.positions, {}};
    for (auto& triangle : triangles) {
        for (int turns = random.below(3); turns > 0; --turns)
            std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
        if (random.below(2)) std::swap(triangle[0], triangle[1]);
        result.indices.insert(result.indices.end(), triangle.begin(), triangle.end());
    }
    return result;
}

/// The soup with a separate position for every corner.
Soup unindexed(const Soup& soup) {
    Soup result;
    for (const std::uint32_t index : soup.indices) {
        result.indices.push_back(static_cast<std::uint32_t>(result.positions.size()));
        result.positions.push_back(soup.positions[index]);
    }
    return result;
}

std::vector<std::vector<float>> sortedCaps(const Built& built) {
    const CapsData caps = buildCaps(built.mesh);
    std::vector<std::vector<float>> records;
    for (std::size_t r = 0; r < caps.recordCount(); ++r) {
        auto& record = records.emplace_back();
        for (const glm::vec4& v : capsRecord(caps, r))
            record.insert(record.end(), {v.x, v.y, v.z, v.w});
    }
    std::sort(records.begin(), records.end());
    return records;
}

} // namespace

RC_GTEST_PROP(Records, DependNeitherOnTheOrderNorTheWindingOfTriangles, ()) {
    const Soup soup = latticeSoup();
    const Built one = build(soup), other = build(shuffled(soup));
    RC_ASSERT(one.mesh.positions == other.mesh.positions);
    RC_ASSERT(one.edges.edges == other.edges.edges);
    RC_ASSERT(one.sides.records == other.sides.records);
    RC_ASSERT(sortedCaps(one) == sortedCaps(other));
}

RC_GTEST_PROP(Records, DoNotDependOnIndexing, ()) {
    const Soup soup = latticeSoup();
    const Built one = build(soup), other = build(unindexed(soup));
    RC_ASSERT(one.mesh.positions == other.mesh.positions);
    RC_ASSERT(one.mesh.triangles == other.mesh.triangles);
    RC_ASSERT(one.edges.edges == other.edges.edges);
    RC_ASSERT(one.edges.opposites == other.edges.opposites);
    RC_ASSERT(one.sides.records == other.sides.records);
}

RC_GTEST_PROP(Edges, AreThePairsOfEveryTriangle, ()) {
    const Built built = build(latticeSoup());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> expected;
    for (const Triangle& triangle : built.mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c)
            ++expected[std::minmax({triangle[c], triangle[(c + 1) % 3]})];
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> found;
    for (const Edge& edge : built.edges.edges)
        found[{edge.a, edge.b}] = edge.oppositeCount;
    RC_ASSERT(found == expected);
    RC_ASSERT(found.size() == built.edges.edges.size());
}

RC_GTEST_PROP(Multiplicity, LiesWithinTheNumberOfOpposites, ()) {
    const Built built = build(latticeSoup());
    const glm::vec4 light = latticeLight();
    const Silhouette silhouette =
        silhouetteOf<shader_arithmetic::ReferenceEdge>(built.sides, light);
    for (const Edge& edge : built.edges.edges) {
        const glm::vec3 a = built.mesh.positions[edge.a], b = built.mesh.positions[edge.b];
        const auto found = silhouette.find({{a.x, a.y, a.z}, {b.x, b.y, b.z}});
        if (found == silhouette.end()) continue;
        RC_ASSERT(std::abs(found->second) <= static_cast<int>(edge.oppositeCount));
    }
}

} // namespace edgeshade::test
