// Records are the same with any number of threads, and the same as those of earlier plain code,
// which sorted by comparison and went triangle by triangle.
#include "tests/preprocess/shared_scene.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/record_hash.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// The plain code's results for a mesh whose first half is single-sided, whose third quarter is
/// double-sided and whose last quarter is alpha-tested.
struct Known {
    const char* kind;
    std::size_t triangles;
    std::uint64_t mesh, records, nearlyFlatRecords; ///< hashes; the last for 3 degrees
};

constexpr Known known[] = {
    {"grid", 12, 0x26d3c6405c71f1a9u, 0x305b10b30bc28144u, 0x305b10b30bc28144u},
    {"grid", 2000, 0xab2145bac266d774u, 0x10f15bd81bf7fb42u, 0xbf45022010ac405eu},
    {"grid", 60000, 0x15539943b8a5f56cu, 0xcdf455074609c56eu, 0xa8c7803cf7c8bf97u},
    {"boxes", 12, 0xc665d2933150dc65u, 0x3cf3a128ac238252u, 0x3cf3a128ac238252u},
    {"boxes", 2000, 0x0e758d6eadbd9d19u, 0xdf681dd97fc9b205u, 0xdf681dd97fc9b205u},
    {"boxes", 60000, 0x7fd3b34489a4c6cdu, 0xe17aa282d5f1fc77u, 0xe17aa282d5f1fc77u},
    {"tangle", 12, 0xf489a210545565afu, 0x455e4ce8e9faf10cu, 0x455e4ce8e9faf10cu},
    {"tangle", 2000, 0x1370a882c33dee8fu, 0x469f8787c878effau, 0x6b97b6aa0daee0d7u},
    {"tangle", 60000, 0xe6e517a9e10824ebu, 0xae9a60649b6e8b9du, 0x7657086555b55708u},
};

CasterMesh casterMesh(WeldedMesh welded) {
    CasterMesh mesh;
    mesh.welded = std::move(welded);
    const auto count = static_cast<std::uint32_t>(mesh.welded.triangles.size());
    const std::uint32_t half = count / 2, quarter = count / 4;
    mesh.groups = {{0, 0, half}, {1, half, quarter}, {2, half + quarter, count - half - quarter}};
    return mesh;
}

std::vector<Material> threeMaterials() {
    std::vector<Material> materials(3);
    materials[1].doubleSided = true;
    materials[2].alphaMode = AlphaMode::mask;
    return materials;
}

/// The costs of records that are made.
PlanePairCosts costsOf(const PlanePairShadow& shadow) {
    constexpr std::size_t quadVertices = 4, capPairVertices = 6;
    PlanePairCosts costs;
    costs.records = shadow.pairs.size() + shadow.singles.size();
    costs.flatEdges = shadow.flatEdges;
    costs.sideBytes =
        shadow.pairs.size() * sizeof(PairRecord) + shadow.singles.size() * sizeof(SingleRecord);
    costs.capBytes = shadow.caps.size() * sizeof(CapRecord);
    costs.capRuns = capPairVertices * shadow.caps.size();
    for (const ShadowCluster& cluster : shadow.clusters)
        costs.sideRuns +=
            quadVertices * ((cluster.closed ? 1 : 2) * cluster.pairs.count + cluster.singles.count);
    return costs;
}

} // namespace

TEST(SameRecords, AsThePlainCodeMadeWithAnyNumberOfThreads) {
    for (const Known& of : known) {
        const Soup soup = generatedMesh(of.kind, of.triangles);
        for (const std::size_t count : {1, 2, 5}) {
            SCOPED_TRACE(std::string(of.kind) + " " + std::to_string(of.triangles) + ", threads " +
                         std::to_string(count));
            const Threads threads{count};
            const CasterMesh mesh = casterMesh(weld(soup.positions, soup.indices, threads));
            const EdgeList edges = buildEdges(mesh.welded, threads);
            EXPECT_EQ(hashOf(mesh.welded, edges), of.mesh);
            const auto hashWith = [&](double flatTolerance) {
                return hashOf(
                    buildPlanePairs(mesh, edges, threeMaterials(), flatTolerance, threads));
            };
            EXPECT_EQ(hashWith(0.0), of.records);
            EXPECT_EQ(hashWith(3.0), of.nearlyFlatRecords);
        }
    }
}

TEST(SameRecords, CountedWithoutMakingThem) {
    for (const char* kind : {"grid", "boxes", "tangle"}) {
        const Soup soup = generatedMesh(kind, 3000);
        const CasterMesh mesh = casterMesh(weld(soup.positions, soup.indices));
        const EdgeList edges = buildEdges(mesh.welded);
        const PlanePairCosts made = costsOf(buildPlanePairs(mesh, edges, threeMaterials(), 3.0));
        const PlanePairCosts counted = planePairCosts(
            mesh, edges, findComponents(mesh.welded, edges), threeMaterials(), 3.0, false);
        EXPECT_EQ(counted.records, made.records) << kind;
        EXPECT_EQ(counted.flatEdges, made.flatEdges) << kind;
        EXPECT_EQ(counted.sideBytes, made.sideBytes) << kind;
        EXPECT_EQ(counted.capBytes, made.capBytes) << kind;
        EXPECT_EQ(counted.sideRuns, made.sideRuns) << kind;
        EXPECT_EQ(counted.capRuns, made.capRuns) << kind;
    }
}

TEST(SameRecords, OfASharedSceneWithAnyNumberOfThreads) {
    SKIP_WITHOUT_SHARED_SCENE("hospital-electrical");
    const Scene scene = readSharedScene("hospital-electrical");
    const Batch& batch = *std::max_element(
        scene.batches.begin(), scene.batches.end(), [](const Batch& a, const Batch& b) {
            return a.geometry->indices.size() < b.geometry->indices.size();
        });
    std::vector<std::uint64_t> hashes;
    for (const std::size_t count : {1, 2, 5}) {
        const Threads threads{count};
        const CasterMesh mesh =
            weldCasters(batch, castersOf(batch, scene.materials, true), threads);
        const EdgeList edges = buildEdges(mesh.welded, threads);
        hashes.push_back(hashOf(buildPlanePairs(mesh, edges, scene.materials, 0.0, threads)));
    }
    EXPECT_EQ(hashes[1], hashes[0]);
    EXPECT_EQ(hashes[2], hashes[0]);
}

} // namespace edgeshade::test
