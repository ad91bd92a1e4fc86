// Casters cut by a plane: no piece on both sides, nothing lost, and still closed.

#include "src/shadow/layers/cut_casters.hpp"

#include "preprocess/mesh/topology.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <map>

namespace edgeshade {
namespace {

glm::dvec3 cornerOf(const Batch& batch, std::size_t i) {
    return glm::dvec3(batch.worldFromBatch *
                      glm::dvec4(batch.geometry->positions[batch.geometry->indices[i]], 1.0));
}

double areaOf(const Batch& batch, std::size_t triangle) {
    const glm::dvec3 a = cornerOf(batch, 3 * triangle);
    return 0.5 * glm::length(glm::cross(cornerOf(batch, 3 * triangle + 1) - a,
                                        cornerOf(batch, 3 * triangle + 2) - a));
}

const glm::dmat4 placed = glm::rotate(glm::translate(glm::dmat4(1.0), {3, -1, 2}), 0.7, {1, 2, -1});
const glm::dvec4 plane(glm::normalize(glm::dvec3(0.3, 1, -0.2)), 0.05);

TEST(CutCasters, AreOnOneSideEachAndKeepTheirArea) {
    const Scene scene = test::yard().placedBy(placed).scene();
    const CutCasters cut = cutCasters(scene, false, plane);
    const Batch& batch = cut.scene.batches.front();
    ASSERT_EQ(cut.from.size(), batch.geometry->indices.size() / 3);
    ASSERT_EQ(cut.inside.size(), cut.from.size());
    std::map<std::uint32_t, double> area;
    std::size_t inside = 0;
    for (std::size_t t = 0; t < cut.from.size(); ++t) {
        area[cut.from[t]] += areaOf(batch, t);
        inside += cut.inside[t];
        for (std::size_t c = 0; c < 3; ++c) {
            const double height = glm::dot(plane, glm::dvec4(cornerOf(batch, 3 * t + c), 1.0));
            EXPECT_GE(cut.inside[t] ? height : -height, -1e-6);
        }
    }
    EXPECT_GT(inside, 5u);
    EXPECT_GT(cut.from.size() - inside, 5u);
    EXPECT_GT(cut.from.size(), scene.triangleCount());
    for (std::uint32_t t = 0; t < scene.triangleCount(); ++t)
        EXPECT_NEAR(area[t], areaOf(scene.batches.front(), t), 1e-5);
}

// A closed mesh has every edge as often in one direction as in the other, and so have its pieces.
TEST(CutCasters, StayClosed) {
    const Scene scene =
        test::SceneBuilder().box({-1, -1, -1}, {1, 1.5f, 2}).placedBy(placed).scene();
    const CutCasters cut = cutCasters(
        scene, false, {0.3, 1, -0.2, -glm::dot(glm::dvec3(0.3, 1, -0.2), glm::dvec3(placed[3]))});
    const Batch& batch = cut.scene.batches.front();
    EXPECT_GT(cut.from.size(), scene.triangleCount());
    const CasterMesh mesh = weldCasters(batch, castersOf(batch, cut.scene.materials, false));
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> direction;
    for (const Triangle& triangle : mesh.welded.triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = triangle[c], b = triangle[(c + 1) % 3];
            direction[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    for (const auto& [edge, sum] : direction)
        EXPECT_EQ(sum, 0);
}

TEST(CutCasters, OfMaskedMaterialsCastOnlyWhereTheyShould) {
    Scene scene = test::yard().scene();
    scene.materials[0].alphaMode = AlphaMode::mask;
    EXPECT_EQ(cutCasters(scene, false, plane).from.size(), 0u);
    EXPECT_GT(cutCasters(scene, true, plane).from.size(), scene.triangleCount());
}

} // namespace
} // namespace edgeshade
