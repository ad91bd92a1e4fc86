#include "src/rivals/synthetic/synthetic.hpp"
#include "tests/support/record_multiplicity.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace edgeshade::bench {
namespace {

TEST(SyntheticMesh, ItsVerticesAreInAscendingOrder) {
    for (const Silhouette silhouette : {Silhouette::all, Silhouette::none}) {
        const SyntheticMesh mesh = syntheticMesh(90'000, 9, silhouette);
        EXPECT_TRUE(std::is_sorted(mesh.positions.begin(), mesh.positions.end(),
                                   [](const glm::vec3& a, const glm::vec3& b) {
                                       return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
                                   }));
    }
}

TEST(SyntheticMesh, EveryEdgeIsASilhouetteEdgeOrNoneIs) {
    for (int opposites = 1; opposites <= 9; ++opposites)
        for (const Silhouette silhouette : {Silhouette::all, Silhouette::none}) {
            const SyntheticMesh mesh = syntheticMesh(2'000, opposites, silhouette);
            const SidesData sides =
                buildSides(mesh.positions, mesh.edges,
                           recordMultiplicityFor(static_cast<std::uint32_t>(opposites)));
            const auto found =
                test::silhouetteOf<shader_arithmetic::ReferenceEdge>(sides, syntheticLight);
            EXPECT_EQ(found.size(), silhouette == Silhouette::all ? 2'000u : 0u);
            for (const auto& [edge, multiplicity] : found)
                EXPECT_EQ(std::abs(multiplicity), opposites);
            if (silhouette == Silhouette::all) continue;
            for (std::size_t r = 0; r < sides.recordCount(); ++r)
                EXPECT_EQ(test::recordMultiplicity<shader_arithmetic::ReferenceEdge>(
                              test::sidesRecord(sides, r), syntheticLight),
                          0.0f);
        }
}

TEST(Synthetic, EveryCellHasATimeAndEveryLayoutAFit) {
    SyntheticTask task;
    task.edges = {100, 200};
    task.multiplicities = {1, 2, 6};
    task.turns = 2;
    const SyntheticReport report = measureSynthetic(task, [](double, const std::string&) {});
    const std::size_t layouts = report.device.instancing ? 5 : 2;
    EXPECT_EQ(report.rows.size(), layouts * 2 * 2 * 3);
    EXPECT_EQ(report.fits.size(), layouts * 2);
    for (const SyntheticRow& row : report.rows)
        EXPECT_GT(row.ms, 0.0);
}

} // namespace
} // namespace edgeshade::bench
