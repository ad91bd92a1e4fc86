// Sections: pieces of triangles, cut faces, and what is shared (docs/method.md, C49 and C50).
#include "preprocess/section/cut_scene.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/scene_builder.hpp"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <map>
#include <tuple>

namespace edgeshade {
namespace {

constexpr double pi = 3.14159265358979;
const glm::vec3 red(1.0f, 0.0f, 0.0f);

Section sectionOf(const std::vector<glm::dvec4>& planes,
                  SectionShadows shadows = SectionShadows::cut) {
    return {planes, shadows, red};
}

using Key = std::array<float, 3>;
Key keyOf(const glm::vec3& p) {
    return {p.x, p.y, p.z};
}

/// Casting triangles of a scene's batch.
std::vector<std::array<glm::vec3, 3>> trianglesOf(const Scene& scene, bool castersAlone,
                                                  std::size_t batch = 0) {
    const Geometry& geometry = *scene.batches[batch].geometry;
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (const SurfaceGroup& group : geometry.groups) {
        const Material& material = scene.materials[group.material];
        if (castersAlone ? !material.casts(false) : !material.isSeen()) continue;
        for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount; i += 3)
            triangles.push_back({geometry.positions[geometry.indices[i]],
                                 geometry.positions[geometry.indices[i + 1]],
                                 geometry.positions[geometry.indices[i + 2]]});
    }
    return triangles;
}

/// Edges whose triangles don't cancel.
std::size_t openEdges(const std::vector<std::array<glm::vec3, 3>>& triangles) {
    std::map<std::pair<Key, Key>, int> sums;
    for (const auto& of : triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            const Key a = keyOf(of[c]), b = keyOf(of[(c + 1) % 3]);
            if (a == b) continue;
            a < b ? ++sums[{a, b}] : --sums[{b, a}];
        }
    std::size_t open = 0;
    for (const auto& [edge, sum] : sums)
        open += sum != 0;
    return open;
}

/// Signed volume, that is the solid's if the surface is closed.
double volumeOf(const std::vector<std::array<glm::vec3, 3>>& triangles) {
    double sum = 0.0;
    for (const auto& of : triangles)
        sum += glm::dot(glm::dvec3(of[0]), glm::cross(glm::dvec3(of[1]), glm::dvec3(of[2]))) / 6.0;
    return sum;
}

double areaOf(const Scene& scene, const SurfaceGroup& group) {
    const Geometry& geometry = *scene.batches.front().geometry;
    double area = 0.0;
    for (std::uint32_t i = group.firstIndex; i < group.firstIndex + group.indexCount; i += 3) {
        const glm::dvec3 a(geometry.positions[geometry.indices[i]]),
            b(geometry.positions[geometry.indices[i + 1]]),
            c(geometry.positions[geometry.indices[i + 2]]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

/// Area of the cut faces of a scene's first batch.
double fillArea(const Scene& scene) {
    double area = 0.0;
    for (const SurfaceGroup& group : scene.batches.front().geometry->groups)
        if (group.material >= scene.whole().materials.size() &&
            scene.materials[group.material].isSeen())
            area += areaOf(scene, group);
    return area;
}

/// A ring of `sides` around a hole, from z = 0 to 1, closed.
Scene pipe(int sides) {
    test::SceneBuilder builder;
    const auto at = [&](int i, double radius, double z) {
        const double angle = 2.0 * pi * (i % sides) / sides;
        return glm::vec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    for (int i = 0; i < sides; ++i) {
        builder.quad(at(i, 1, 0), at(i + 1, 1, 0), at(i + 1, 1, 1), at(i, 1, 1));
        builder.quad(at(i + 1, 0.5, 0), at(i, 0.5, 0), at(i, 0.5, 1), at(i + 1, 0.5, 1));
        builder.quad(at(i, 0.5, 1), at(i, 1, 1), at(i + 1, 1, 1), at(i + 1, 0.5, 1));
        builder.quad(at(i + 1, 0.5, 0), at(i + 1, 1, 0), at(i, 1, 0), at(i, 0.5, 0));
    }
    return builder.scene();
}

Scene boxScene() {
    return test::SceneBuilder().box({-1, -1, -1}, {1, 1, 1}).scene();
}

TEST(Section, FillsTheCutOfASolid) {
    SceneCutter cutter(boxScene(), false);
    const Scene cut = cutter.cut(sectionOf({{0, -1, 0, 0.25}}));
    EXPECT_NEAR(fillArea(cut), 4.0, 1e-5);
    EXPECT_EQ(openEdges(trianglesOf(cut, true)), 0u);
    EXPECT_NEAR(volumeOf(trianglesOf(cut, true)), 4.0 * 1.25, 1e-5);
    EXPECT_FALSE(cut.culls);
    EXPECT_EQ(cut.materials[cut.whole().materials.size()].baseColorFactor, glm::vec4(red, 1.0f));
}

TEST(Section, LeavesTheHoleOfARingOpen) {
    SceneCutter cutter(pipe(24), false);
    const Scene cut = cutter.cut(sectionOf({{0, 0, -2, 1}}));
    const double ring = 0.5 * 24 * std::sin(2.0 * pi / 24) * (1.0 - 0.25);
    EXPECT_NEAR(fillArea(cut), ring, 1e-5);
    EXPECT_EQ(openEdges(trianglesOf(cut, true)), 0u);
}

TEST(Section, LeavesOpenMeshesOpen) {
    SceneCutter cutter(test::SceneBuilder().floor(5).scene(), false);
    const Scene cut = cutter.cut(sectionOf({{1, 0, 0, 0}}));
    EXPECT_EQ(fillArea(cut), 0.0);
    double area = 0.0;
    for (const SurfaceGroup& group : cut.batches.front().geometry->groups)
        area += areaOf(cut, group);
    EXPECT_NEAR(area, 50.0, 1e-4);
}

TEST(Section, WithoutAFillLeavesSolidsOpen) {
    SceneCutter cutter(boxScene(), false);
    const Scene cut = cutter.cut({{{0, -1, 0, 0.25}}, SectionShadows::cut, {}});
    EXPECT_EQ(fillArea(cut), 0.0);
    EXPECT_GT(openEdges(trianglesOf(cut, true)), 0u);
}

/// Planes through vertices, edges and faces of a box, askew, and in pairs.
std::vector<std::vector<glm::dvec4>> hardPlanes() {
    return {{{0, 1, 0, 1}},
            {{0, -1, 0, 1}},
            {{0, 1, 0, -1}},
            {{1, 1, 0, 0}},
            {{1, 1, 1, 0}},
            {{1, 1, 1, -1}},
            {{1, 1, 1, 3}},
            {{1e-9, 1, 1e-9, 0}},
            {{0.3, 0.7, -0.2, 0.1}, {-0.5, 0.1, 0.9, 0.2}},
            {{1, 0, 0, 0}, {-1, 0, 0, 0.5}, {0, 1, 0, 0.25}, {0, -1, 0, 0.25}},
            {{1, 0, 0, 0}, {-1, 0, 0, 0}},
            {{1, 1, 1, 0}, {-1, -1, -1, 0}}};
}

TEST(Section, SolidsStayClosedUnderHardPlanes) {
    for (const Scene& scene : {boxScene(), pipe(7)}) {
        SceneCutter cutter(scene, false);
        for (const auto& planes : hardPlanes()) {
            SCOPED_TRACE(testing::PrintToString(planes.front().w));
            const Scene cut = cutter.cut(sectionOf(planes));
            EXPECT_EQ(openEdges(trianglesOf(cut, true)), 0u);
        }
    }
}

TEST(Section, LeavesNothingOfASolidThatTouchesThePlaneFromBehind) {
    SceneCutter cutter(boxScene(), false);
    for (const glm::dvec4& plane : {glm::dvec4(0, 1, 0, -1), glm::dvec4(-1, 0, 0, -1)})
        EXPECT_TRUE(trianglesOf(cutter.cut(sectionOf({plane})), false).empty());
    // From before, its face stays.
    EXPECT_EQ(trianglesOf(cutter.cut(sectionOf({{0, -1, 0, 1}})), false).size(), 12u);
}

TEST(Section, KeptAndCutAwaySolidsAddUp) {
    for (const auto& planes : hardPlanes()) {
        if (planes.size() > 1) continue;
        SceneCutter cutter(pipe(9), false);
        const double whole = volumeOf(trianglesOf(cutter.whole(), true));
        const double one = volumeOf(trianglesOf(cutter.cut(sectionOf(planes)), true));
        const double other = volumeOf(trianglesOf(cutter.cut(sectionOf({-planes[0]})), true));
        EXPECT_NEAR(one + other, whole, 1e-5);
    }
}

TEST(Section, OfRandomClosedSoupsStaysClosed) {
    test::Random random(5);
    for (int turn = 0; turn < 60; ++turn) {
        // Tetrahedra that share vertices, edges and faces: chains without a boundary.
        test::SceneBuilder builder;
        std::vector<glm::vec3> points;
        for (int i = 0; i < 6; ++i)
            points.emplace_back(turn % 2 == 0 ? glm::round(3.0 * random.inCube())
                                              : 3.0 * random.inCube());
        for (int i = 0; i < 4; ++i) {
            std::array<glm::vec3, 4> p;
            for (glm::vec3& of : p)
                of = points[random.below(6)];
            builder.triangle(p[0], p[2], p[1]).triangle(p[0], p[1], p[3]);
            builder.triangle(p[1], p[2], p[3]).triangle(p[2], p[0], p[3]);
        }
        SceneCutter cutter(builder.scene(), false);
        for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
            const glm::dvec4 plane(glm::round(2.0 * random.inCube()) + glm::dvec3(0.0, 0.0, 3.0),
                                   std::round(random.uniform(-2.0, 2.0)));
            Section section = sectionOf({plane}, shadows);
            section.fill.reset();
            const Scene open = cutter.cut(section);
            // Whole casters are closed without a fill; cut ones are open at the plane alone.
            if (shadows == SectionShadows::whole) {
                EXPECT_EQ(openEdges(trianglesOf(open, true)), 0u);
            } else {
                for (const auto& of : trianglesOf(open, true))
                    for (const glm::vec3& corner : of)
                        EXPECT_GE(glm::dot(plane, glm::dvec4(corner, 1.0)), -1e-5);
            }
        }
    }
}

TEST(Section, ThatCastsWholeKeepsAllCasters) {
    SceneCutter cutter(pipe(12), false);
    const double whole = volumeOf(trianglesOf(cutter.whole(), true));
    for (const auto& planes : hardPlanes()) {
        const Scene cut = cutter.cut(sectionOf(planes, SectionShadows::whole));
        EXPECT_EQ(openEdges(trianglesOf(cut, true)), 0u);
        EXPECT_NEAR(volumeOf(trianglesOf(cut, true)), whole, 1e-5);
    }
    const Scene cut = cutter.cut(sectionOf({{0, 0, -1, 0.5}}, SectionShadows::whole));
    EXPECT_GT(fillArea(cut), 1.0);
    for (const auto& of : trianglesOf(cut, false))
        for (const glm::vec3& corner : of)
            EXPECT_LE(corner.z, 0.5f);
}

TEST(Section, SharesWhatNoPlaneCrosses) {
    Scene scene = boxScene();
    for (const double x : {-10.0, 10.0, 20.0, 0.1}) {
        Batch place = scene.batches.front();
        place.worldFromBatch = glm::translate(glm::dmat4(1.0), {x, 0.0, 0.0});
        scene.batches.push_back(place);
    }
    SceneCutter cutter(scene, false);
    const auto geometryOf = [](const Scene& of, std::size_t i) { return &*of.batches[i].geometry; };
    for (const SectionShadows shadows : {SectionShadows::cut, SectionShadows::whole}) {
        const Scene cut = cutter.cut(sectionOf({{-1, 0, 0, 0.5}}, shadows));
        EXPECT_EQ(geometryOf(cut, 1), geometryOf(scene, 1)); // kept
        EXPECT_EQ(geometryOf(cut, 2), geometryOf(cut, 3));   // away, both wholly
        EXPECT_NE(geometryOf(cut, 0), geometryOf(scene, 0));
        EXPECT_NE(geometryOf(cut, 0), geometryOf(cut, 4)); // cut elsewhere
        EXPECT_EQ(trianglesOf(cut, false, 2).size(), 0u);
        EXPECT_EQ(trianglesOf(cut, true, 2).size(), shadows == SectionShadows::whole ? 12u : 0u);
    }
    EXPECT_EQ(geometryOf(cutter.cut({}), 0), geometryOf(scene, 0));
}

TEST(Section, InterpolatesAttributes) {
    Scene scene = test::SceneBuilder().triangle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}).scene();
    Geometry& geometry = scene.batches.front().geometry.edit();
    geometry.texcoords = {{0, 0}, {2, 0}, {0, 2}};
    SceneCutter cutter(scene, false);
    const Scene cut = cutter.cut(sectionOf({{-1, 0, 0, 0.5}}));
    const Geometry& made = *cut.batches.front().geometry;
    for (const std::uint32_t i : made.indices) {
        EXPECT_NEAR(made.texcoords[i].x, made.positions[i].x, 1e-6);
        EXPECT_NEAR(made.texcoords[i].y, made.positions[i].y, 1e-6);
        EXPECT_NEAR(glm::length(made.normals[i]), 1.0, 1e-6);
        EXPECT_LE(made.positions[i].x, 0.5f);
    }
}

TEST(Section, CutsFarOffAndTinyAndHugeBatchesAlike) {
    for (const double size : {1e-6, 1.0, 1e6})
        for (const double away : {0.0, 1e7}) {
            Scene scene = boxScene();
            scene.batches.front().worldFromBatch = glm::scale(
                glm::translate(glm::dmat4(1.0), glm::dvec3(away * size)), glm::dvec3(size));
            SceneCutter cutter(scene, false);
            const Scene cut = cutter.cut(sectionOf({{0, -1, 0, (away + 0.25) * size}}));
            EXPECT_NEAR(volumeOf(trianglesOf(cut, true)), 5.0, 1e-4);
            EXPECT_EQ(openEdges(trianglesOf(cut, true)), 0u);
        }
}

TEST(Section, ClosesNestedAndOverlappingSolids) {
    test::SceneBuilder builder;
    builder.box({-2, -2, -2}, {2, 2, 2}).box({-1, -1, -1}, {3, 1, 1});
    SceneCutter cutter(builder.scene(), false);
    const Scene cut = cutter.cut(sectionOf({{0, -1, 0, 0}}));
    EXPECT_NEAR(fillArea(cut), 16.0 + 2.0, 1e-4); // the union, once
}

TEST(Section, BoundsAreThoseOfTheWholeScene) {
    SceneCutter cutter(boxScene(), false);
    const Box box = worldBounds(cutter.cut(sectionOf({{0, -1, 0, 0}})));
    EXPECT_EQ(box.high.y, 1.0);
}

} // namespace
} // namespace edgeshade
