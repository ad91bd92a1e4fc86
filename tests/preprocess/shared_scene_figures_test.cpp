// Statistics of real models (docs/method.md), welded on exact positions. Closed counts edges with
// as many triangles in one direction as in the other, whatever their number.
#include "preprocess/volumes/shadow_data.hpp"
#include "shared_scene.hpp"

#include <gtest/gtest.h>
#include <iostream>
#include <string>

namespace edgeshade::test {
namespace {

using ByCount = std::map<std::uint32_t, std::size_t>;

/// All casters if MASK and BLEND surfaces cast too.
MeshStatistics statisticsOf(const std::string& name) {
    BuildSeconds seconds;
    MeshStatistics sum;
    for (const auto& batch :
         buildTopology(readSharedScene(name, InstanceChoice::repeated), true, seconds))
        sum += meshStatistics(batch->mesh.welded, batch->edges);
    std::cout << "[ figures      ] " << name << ": " << sum.triangles << " triangles, "
              << sum.degenerateTriangles << " degenerate, " << sum.edges << " edges, "
              << sum.components << " components, " << sum.closedOrientedTriangles
              << " triangles closed and oriented;";
    for (const auto& [n, count] : sum.edgesByOppositeCount)
        std::cout << " n=" << n << ": " << count;
    std::cout << "\n";
    return sum;
}

} // namespace

TEST(SharedSceneFigures, Bunny) {
    SKIP_WITHOUT_SHARED_SCENE("bunny.draco");
    const MeshStatistics statistics = statisticsOf("bunny.draco");
    EXPECT_EQ(statistics.triangles, 144046u);
    EXPECT_EQ(statistics.degenerateTriangles, 0u);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{2, 216069}}));
    EXPECT_EQ(statistics.closedOrientedTriangles, 144046u);
}

TEST(SharedSceneFigures, Engine) {
    SKIP_WITHOUT_SHARED_SCENE("engine");
    const MeshStatistics statistics = statisticsOf("engine");
    EXPECT_EQ(statistics.triangles + statistics.degenerateTriangles, 121496u);
    EXPECT_EQ(statistics.degenerateTriangles, 11160u);
    EXPECT_EQ(statistics.edges, 172158u);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 13308}, {2, 158850}}));
    EXPECT_EQ(statistics.closedOrientedTriangles, 12558u);
}

TEST(SharedSceneFigures, HospitalElectrical) {
    SKIP_WITHOUT_SHARED_SCENE("hospital-electrical");
    const MeshStatistics statistics = statisticsOf("hospital-electrical");
    EXPECT_EQ(statistics.triangles + statistics.degenerateTriangles, 153990u);
    EXPECT_EQ(statistics.edges, 225478u);
    EXPECT_EQ(statistics.largestOppositeCount(), 4u);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 22}, {2, 219938}, {4, 5518}}));
    EXPECT_EQ(statistics.closedOrientedTriangles, 153774u);
}

TEST(SharedSceneFigures, Oaktree) {
    SKIP_WITHOUT_SHARED_SCENE("oaktree");
    const MeshStatistics statistics = statisticsOf("oaktree");
    EXPECT_EQ(statistics.triangles + statistics.degenerateTriangles, 5302u);
    EXPECT_EQ(statistics.edges, 7892u);
    EXPECT_EQ(statistics.edgesByOppositeCount, (ByCount{{1, 558}, {2, 7164}, {6, 170}}));
    EXPECT_EQ(statistics.closedOrientedTriangles, 1020u);
}

} // namespace edgeshade::test
