#include "preprocess/mesh/topology.hpp"

#include "preprocess/volumes/shadow_data.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// Materials by place: opaque, MASK, BLEND.
std::vector<Material> everyAlphaMode() {
    std::vector<Material> materials(3);
    materials[1].alphaMode = AlphaMode::mask;
    materials[2].alphaMode = AlphaMode::blend;
    return materials;
}

//   1---3---5      one square an alpha mode, two triangles each
//   |\  |\  |\     and between them a degenerate triangle of the MASK square
//   0---2---4---6
Batch everyKindOfSurface() {
    Batch batch;
    batch.geometry.edit().positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0},
                                       {2, 0, 0}, {2, 1, 0}, {3, 0, 0}};
    batch.geometry.edit().indices = {0, 2, 1, 1, 2, 3,          // opaque
                                     2, 2, 3, 2, 4, 3, 3, 4, 5, // MASK
                                     4, 6, 5};                  // BLEND
    batch.geometry.edit().groups = {{0, 0, 6}, {1, 6, 9}, {2, 15, 3}};
    return batch;
}

Casters castersFrom(const Batch& batch, bool castMasked) {
    return castersOf(batch, everyAlphaMode(), castMasked);
}

/// One triangle (1,2,3) (4,5,6) (7,8,9).
Batch oneTriangle() {
    Batch batch;
    batch.geometry.edit().positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    batch.geometry.edit().indices = {0, 1, 2};
    batch.geometry.edit().groups = {{0, 0, 3}};
    return batch;
}

std::uint64_t hashOf(const Batch& batch) {
    return positionsHash(batch, castersFrom(batch, false));
}

} // namespace

TEST(Casters, OnlyOpaqueSurfacesCastUnlessAsked) {
    const Casters casters = castersFrom(everyKindOfSurface(), false);
    EXPECT_EQ(casters.indices, (std::vector<std::uint32_t>{0, 2, 1, 1, 2, 3}));
    ASSERT_EQ(casters.groups.size(), 1u);
    EXPECT_EQ(casters.groups[0].material, 0u);
}

TEST(Casters, EveryKindCastsWhenAsked) {
    const Batch batch = everyKindOfSurface();
    const Casters casters = castersFrom(batch, true);
    EXPECT_EQ(casters.indices, batch.geometry->indices);
    ASSERT_EQ(casters.groups.size(), 3u);
    EXPECT_EQ(casters.groups[2].material, 2u);
    EXPECT_EQ(casters.groups[2].firstIndex, 15u);
    EXPECT_EQ(casters.groups[2].indexCount, 3u);
}

TEST(Casters, GroupsAreRangesOfTheCastersOnly) {
    // The first group does not cast: the next one starts at 0.
    Batch batch = everyKindOfSurface();
    auto& groups = batch.geometry.edit().groups;
    std::swap(groups[0].material, groups[1].material);
    const Casters casters = castersFrom(batch, false);
    ASSERT_EQ(casters.groups.size(), 1u);
    EXPECT_EQ(casters.groups[0].firstIndex, 0u);
    EXPECT_EQ(casters.groups[0].indexCount, 9u);
    EXPECT_EQ(casters.indices, (std::vector<std::uint32_t>{2, 2, 3, 2, 4, 3, 3, 4, 5}));
}

TEST(CasterMesh, GroupsOfCapsLeaveOutDegenerateTriangles) {
    const Batch batch = everyKindOfSurface();
    const CasterMesh mesh = weldCasters(batch, castersFrom(batch, true));
    EXPECT_EQ(mesh.welded.degenerate, 1u);
    ASSERT_EQ(mesh.groups.size(), 3u);
    const std::uint32_t firstCaps[] = {0, 2, 4}, capCounts[] = {2, 2, 1};
    for (std::size_t g = 0; g < 3; ++g) {
        EXPECT_EQ(mesh.groups[g].material, g);
        EXPECT_EQ(mesh.groups[g].firstCap, firstCaps[g]);
        EXPECT_EQ(mesh.groups[g].capCount, capCounts[g]);
    }
}

TEST(CasterMesh, AGroupOfDegenerateTrianglesAloneIsLeftOut) {
    Batch batch = everyKindOfSurface();
    batch.geometry.edit().groups = {{0, 0, 6}, {1, 6, 3}, {2, 9, 9}};
    const CasterMesh mesh = weldCasters(batch, castersFrom(batch, true));
    ASSERT_EQ(mesh.groups.size(), 2u);
    EXPECT_EQ(mesh.groups[1].material, 2u);
    EXPECT_EQ(mesh.groups[1].firstCap, 2u);
    EXPECT_EQ(mesh.groups[1].capCount, 3u);
}

TEST(CasterMesh, SurfacesOfAllMaterialsAreWeldedTogether) {
    // A strip of three squares: 5 triangles, with 4 of 11 edges inside.
    const Batch batch = everyKindOfSurface();
    Scene scene;
    scene.batches = {batch};
    scene.materials = everyAlphaMode();
    BuildSeconds seconds;
    const auto topology = buildTopology(scene, true, seconds);
    ASSERT_EQ(topology.size(), 1u);
    const MeshStatistics statistics = meshStatistics(topology[0]->mesh.welded, topology[0]->edges);
    EXPECT_EQ(statistics.edgesByOppositeCount,
              (std::map<std::uint32_t, std::size_t>{{1, 7}, {2, 4}}));
    EXPECT_EQ(statistics.components, 1u);
}

TEST(BuildShadow, SidesAndCapsOfTheWholeBatch) {
    Scene scene;
    scene.batches = {everyKindOfSurface(), oneTriangle()};
    scene.materials = everyAlphaMode();
    const auto shadows = buildShadows(scene, true);
    ASSERT_EQ(shadows.size(), 2u);
    EXPECT_EQ(shadows[0]->sides.recordCount(), 11u);
    EXPECT_EQ(shadows[0]->caps.recordCount(), 5u);
    EXPECT_EQ(shadows[1]->sides.recordCount(), 3u);
    EXPECT_EQ(shadows[1]->caps.recordCount(), 1u);
    // One multiplicity for the whole scene, though the second batch needs only one.
    EXPECT_EQ(shadows[1]->sides.maxMultiplicity, 2);
}

TEST(BuildShadow, ABatchWithoutCastersHasNone) {
    Scene scene;
    scene.batches = {everyKindOfSurface()};
    scene.batches[0].geometry.edit().groups[0].material = 1;
    scene.materials = everyAlphaMode();
    const auto shadows = buildShadows(scene, false);
    ASSERT_EQ(shadows.size(), 1u);
    EXPECT_EQ(shadows[0]->sides.recordCount(), 0u);
    EXPECT_EQ(shadows[0]->caps.recordCount(), 0u);
    EXPECT_TRUE(shadows[0]->groups.empty());
}

TEST(PositionsHash, IsFnv1aOfTheCornersBytes) {
    EXPECT_EQ(hashOf(Batch{}), 0xCBF29CE484222325u); // for nothing: its offset basis
    EXPECT_EQ(hashOf(oneTriangle()), 0x238D5E61A778ED18u);
}

TEST(PositionsHash, ChangesWithOneUnitInTheLastPlace) {
    for (std::size_t vertex = 0; vertex < 3; ++vertex)
        for (glm::length_t c = 0; c < 3; ++c) {
            Batch moved = oneTriangle();
            float& coordinate = moved.geometry.edit().positions[vertex][c];
            coordinate = std::nextafter(coordinate, 0.0f);
            EXPECT_NE(hashOf(moved), hashOf(oneTriangle()));
        }
}

TEST(PositionsHash, ChangesWithTheOrderOfCorners) {
    Batch turned = oneTriangle();
    turned.geometry.edit().indices = {1, 2, 0};
    EXPECT_NE(hashOf(turned), hashOf(oneTriangle()));
}

TEST(PositionsHash, DoesNotDependOnIndexing) {
    Batch reindexed = oneTriangle();
    reindexed.geometry.edit().positions = {{9, 9, 9}, {7, 8, 9}, {4, 5, 6}, {1, 2, 3}};
    reindexed.geometry.edit().indices = {3, 2, 1};
    EXPECT_EQ(hashOf(reindexed), hashOf(oneTriangle()));
}

TEST(PositionsHash, CoversTheCastersAlone) {
    Batch batch = everyKindOfSurface();
    const auto before = positionsHash(batch, castersFrom(batch, false));
    const auto beforeOfAll = positionsHash(batch, castersFrom(batch, true));
    batch.geometry.edit().positions[6].z = 1;
    EXPECT_EQ(positionsHash(batch, castersFrom(batch, false)), before);
    EXPECT_NE(positionsHash(batch, castersFrom(batch, true)), beforeOfAll);
}

} // namespace edgeshade::test
