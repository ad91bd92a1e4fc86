// The tree of a cut scene follows from that of the whole scene: it must answer as a loop over all
// triangles does, bit for bit, and have the leaves that no plane touches as they were.
#include "preprocess/section/cut_scene.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/plain_visible_part.hpp"
#include "tests/support/small_soups.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::findsTheSame;
using test::Random;
using test::Soup;

/// A batch for each soup: opaque, then masked triangles, which may be double-sided.
Scene sceneOf(const std::vector<Soup>& soups, Random& random) {
    Scene scene;
    scene.culls = true;
    scene.materials.resize(2);
    scene.materials[1].alphaMode = AlphaMode::mask;
    scene.materials[1].doubleSided = random.below(2) == 0;
    for (const Soup& soup : soups) {
        Geometry geometry;
        geometry.positions = soup.positions;
        geometry.normals.assign(soup.positions.size(), {0.0f, 1.0f, 0.0f});
        geometry.texcoords.resize(soup.positions.size());
        geometry.colors.resize(soup.positions.size(), glm::vec4(1.0f));
        geometry.indices = soup.indices;
        const auto count = static_cast<std::uint32_t>(soup.indices.size());
        const std::uint32_t opaque = count - 3 * (count / 3 / 8);
        geometry.groups = {{0, 0, opaque}};
        if (count > opaque) geometry.groups.push_back({1, opaque, count - opaque});
        scene.batches.emplace_back().geometry = CopyOnWrite(std::move(geometry));
    }
    return scene;
}

/// A plane through a vertex, an edge or a face of the soup, or at random.
glm::dvec4 somePlane(Random& random, const Soup& soup) {
    const std::size_t triangle =
        static_cast<std::size_t>(random.below(static_cast<int>(soup.indices.size() / 3)));
    const auto corner = [&](std::size_t c) {
        return glm::dvec3(soup.positions[soup.indices[3 * triangle + c]]);
    };
    glm::dvec3 normal = random.inCube();
    switch (random.below(4)) {
    case 0:
        normal = glm::cross(corner(1) - corner(0), normal);
        break;
    case 1:
        normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        break;
    case 2:
        normal = {0.0, random.below(2) == 0 ? 1.0 : -1.0, 0.0};
        break;
    default:
        break;
    }
    if (normal == glm::dvec3(0.0)) normal = {1.0, 0.0, 0.0};
    return {normal, -glm::dot(normal, corner(0))};
}

Section someSection(Random& random, const std::vector<Soup>& soups) {
    Section section;
    section.shadows = random.below(2) == 0 ? SectionShadows::cut : SectionShadows::whole;
    if (random.below(3) != 0) section.fill = glm::vec3(1.0f);
    do
        section.planes.push_back(
            somePlane(random, soups[static_cast<std::size_t>(random.below(int(soups.size())))]));
    while (random.below(3) == 0);
    return section;
}

Frustum someFrustum(Random& random, const Scene& scene) {
    const Box bounds = worldBounds(scene);
    const glm::dvec3 eye = bounds.center() + bounds.diagonal() * random.inCube();
    const glm::dvec3 to = eye + random.inCube() + glm::dvec3(0.0, 0.0, 1e-3);
    return frustumOf({eye, to, random.uniform(5.0, 120.0)}, 1.3);
}

/// Visible triangles of a batch, ascending.
std::vector<std::uint32_t> seenOf(const Scene& scene, const Batch& batch) {
    std::vector<std::uint32_t> seen;
    for (const SurfaceGroup& group : batch.geometry->groups)
        if (scene.materials[group.material].isSeen())
            for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount;
                 i += 3)
                seen.push_back(i / 3);
    return seen;
}

/// The triangles of all leaves of a tree, ascending.
std::vector<std::uint32_t> inLeavesOf(const TriangleTree& tree) {
    std::vector<std::uint32_t> all;
    for (std::size_t leaf = 0; leaf < tree.boxes().items(); ++leaf) {
        const auto triangles = tree.trianglesOf(leaf);
        EXPECT_GT(triangles.size(), 0u);
        EXPECT_LE(triangles.size(), TriangleTree::leafSize);
        all.insert(all.end(), triangles.begin(), triangles.end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

void drag(Random& random, const std::vector<Soup>& soups, int steps) {
    SceneCutter cutter(sceneOf(soups, random), false);
    SceneTree tree;
    if (random.below(2) == 0) tree.update(cutter.whole()); // it then has cones
    for (int step = 0; step < steps; ++step) {
        // Now and then whole again.
        const Scene scene =
            random.below(8) == 0 ? cutter.whole() : cutter.cut(someSection(random, soups));
        tree.update(scene);
        for (std::size_t i = 0; i < scene.batches.size(); ++i) {
            const TriangleTree& of = tree.trianglesOf(i);
            EXPECT_EQ(inLeavesOf(of), seenOf(scene, scene.batches[i]));
            const TriangleTree fresh(*scene.batches[i].geometry, scene.materials);
            EXPECT_EQ(of.bounds().low, fresh.bounds().low);
            EXPECT_EQ(of.bounds().high, fresh.bounds().high);
            EXPECT_EQ(of.farthest(), fresh.farthest());
        }
        for (int view = 0; view < 6; ++view)
            EXPECT_TRUE(findsTheSame(scene, tree, someFrustum(random, scene)));
        if (testing::Test::HasFailure()) return;
    }
}

TEST(CutTree, OfRandomSoupsAnswersAsEveryTriangle) {
    Random random(71);
    for (int turn = 0; turn < 60; ++turn) {
        SCOPED_TRACE(turn);
        std::vector<Soup> soups;
        for (int i = 1 + random.below(3); i > 0; --i)
            soups.push_back(test::randomSoup(random, 1 + random.below(60)));
        drag(random, soups, 6);
        if (HasFailure()) return;
    }
}

TEST(CutTree, OfSolidsSheetsAndTanglesAnswersAsEveryTriangle) {
    Random random(72);
    for (int turn = 0; turn < 4; ++turn) {
        SCOPED_TRACE(turn);
        drag(random, {test::manyBoxes(600), test::hillyGrid(800), test::tangle(200)}, 8);
        if (HasFailure()) return;
    }
}

// Leaves away from the plane have the triangles of the whole scene's leaves; those that are cut
// away are gone.
TEST(CutTree, KeepsTheLeavesThatNoPlaneTouches) {
    Random random(73);
    const Soup soup = test::hillyGrid(4000);
    SceneCutter cutter(sceneOf({soup}, random), false);
    SceneTree tree(cutter.whole());
    const TriangleTree whole = tree.trianglesOf(0);
    const Box bounds = worldBounds(cutter.whole());
    const Scene scene =
        cutter.cut({{{1.0, 0.0, 0.0, -bounds.center().x}}, SectionShadows::cut, glm::vec3(1.0f)});
    tree.update(scene);
    const TriangleTree& cut = tree.trianglesOf(0);
    const CutOrigins& origins = *scene.batches[0].origins;
    std::size_t same = 0, leaf = 0;
    for (std::size_t before = 0; before < whole.boxes().items() && leaf < cut.boxes().items();
         ++before) {
        std::vector<std::uint32_t> from;
        for (const std::uint32_t triangle : cut.trianglesOf(leaf))
            from.push_back(origins.ofTriangle[triangle]);
        const auto all = whole.trianglesOf(before);
        if (std::find(all.begin(), all.end(), from.front()) == all.end()) continue;
        same += std::equal(all.begin(), all.end(), from.begin(), from.end());
        ++leaf;
    }
    EXPECT_GT(same, whole.boxes().items() / 3) << "of half a scene";
    EXPECT_LT(cut.boxes().items(), whole.boxes().items() * 2 / 3);
}

} // namespace
} // namespace edgeshade
