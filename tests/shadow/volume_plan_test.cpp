#include "preprocess/volumes/clustering.hpp"
#include "src/shadow/geometry/box_plane.hpp"
#include "src/shadow/plan/ray_crossings.hpp"
#include "src/shadow/plan/stencil_start.hpp"

#include "tests/support/hard_lights.hpp"
#include "tests/support/planned_volumes.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;

Box boxAround(const glm::dvec3& center, double halfSize) {
    Box box;
    box.add(center - halfSize);
    box.add(center + halfSize);
    return box;
}

CapRecord capOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 p(a);
    const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(b) - p, glm::dvec3(c) - p));
    return {a, b, c, glm::vec4(glm::dvec4(normal, -glm::dot(normal, p)))};
}

/// The twelve triangles of a box, seen from outside.
void appendShell(const Box& box, std::vector<CapRecord>& caps) {
    const auto corner = [&](int i) {
        return glm::vec3(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                         i & 4 ? box.high.z : box.low.z);
    };
    constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : faces)
        for (const auto& [p, q, r] : {std::array{f[0], f[1], f[2]}, std::array{f[0], f[2], f[3]}})
            caps.push_back(capOf(corner(p), corner(q), corner(r)));
}

/// The plan for clusters that are shells of their bounds.
VolumePlan planOf(const std::vector<ShadowCluster>& clusters, const PlanView& view) {
    PlanePairShadow shadow;
    for (ShadowCluster cluster : clusters) {
        cluster.caps = {static_cast<std::uint32_t>(shadow.caps.size()), 12};
        cluster.leaves = {static_cast<std::uint32_t>(shadow.leaves.size()), 1};
        appendShell(cluster.bounds, shadow.caps);
        shadow.leaves.push_back(cluster.bounds);
        shadow.clusters.push_back(cluster);
    }
    return test::planVolumes(shadow, view);
}

std::vector<ClusterPlan> planFor(const std::vector<ShadowCluster>& clusters, const PlanView& view) {
    return planOf(clusters, view).drawn;
}

ShadowCluster clusterAt(const glm::dvec3& center, double halfSize, bool closed = true,
                        bool holes = false) {
    ShadowCluster cluster;
    cluster.bounds = boxAround(center, halfSize);
    cluster.closed = closed;
    cluster.alphaTested = holes;
    return cluster;
}

/// From the origin along -z, 60 degrees in both directions, from 0.1 to 100.
FrameView viewAlongZ() {
    FrameView view;
    view.frustum = frustumOf({{0, 0, 0}, {0, 0, -1}, 60.0}, 1.0);
    view.width = view.height = 64;
    view.slices = {{0.1, std::numeric_limits<double>::infinity()}};
    view.farthestDepth = 100.0;
    return view;
}

std::vector<ClusterPlan> planFor(const ShadowCluster& cluster, const glm::dvec4& light,
                                 const glm::dmat4& worldFromBatch = glm::dmat4(1.0)) {
    const FrameView view = viewAlongZ();
    const std::vector<ShadowCluster> clusters = {cluster};
    return planFor(clusters, planView(view, view.slices[0], {light}, worldFromBatch));
}

ClusterPlan onlyDraw(const ShadowCluster& cluster, const glm::dvec4& light) {
    const auto draws = planFor(cluster, light);
    EXPECT_EQ(draws.size(), 1u);
    return draws.empty() ? ClusterPlan() : draws.front();
}

/// One cluster of small triangles, in leaves of neighbours.
PlanePairShadow scatteredCaps(std::uint32_t count, Random& random) {
    PlanePairShadow shadow;
    glm::dvec3 place = random.inCube();
    Box bounds;
    for (std::uint32_t cap = 0; cap < count; ++cap) {
        place += 0.02 * random.inCube();
        if (cap % leafTriangles == 0) shadow.leaves.emplace_back();
        const glm::vec3 corners[] = {glm::vec3(place + 0.05 * random.inCube()),
                                     glm::vec3(place + 0.05 * random.inCube()),
                                     glm::vec3(place + 0.05 * random.inCube())};
        shadow.caps.push_back(capOf(corners[0], corners[1], corners[2]));
        for (const glm::vec3& corner : corners) {
            shadow.leaves.back().add(glm::dvec3(corner));
            bounds.add(glm::dvec3(corner));
        }
    }
    ShadowCluster cluster;
    cluster.bounds = bounds;
    cluster.caps = {0, count};
    cluster.leaves = {0, static_cast<std::uint32_t>(shadow.leaves.size())};
    shadow.clusters.push_back(cluster);
    return shadow;
}

} // namespace

TEST(Separation, OfWhatIsPlainlyApartOrNot) {
    const NearClipVolume pyramid{{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, {0, 0, 10, 1}};
    EXPECT_FALSE(areApart(pyramid, boxAround({0, 0, 5}, 0.1)));
    EXPECT_FALSE(areApart(pyramid, boxAround({0, 0, 10}, 0.1)));
    EXPECT_FALSE(areApart(pyramid, boxAround({0, 0, 0}, 0.1)));
    EXPECT_TRUE(areApart(pyramid, boxAround({0, 0, 12}, 0.1)));
    EXPECT_TRUE(areApart(pyramid, boxAround({0, 0, -2}, 0.1)));
    EXPECT_TRUE(areApart(pyramid, boxAround({0.9, 0.9, 5}, 0.1)));
    EXPECT_TRUE(areApart(pyramid, Box()));
    NearClipVolume prism = pyramid;
    prism.light = {0, 0, 1, 0};
    EXPECT_FALSE(areApart(prism, boxAround({0.9, 0.9, 1e6}, 0.2)));
    EXPECT_TRUE(areApart(prism, boxAround({0, 0, -2}, 0.1)));
    EXPECT_TRUE(areApart(prism, boxAround({3, 0, 5}, 0.1)));
}

TEST(Separation, NeverPartsWhatTouches) {
    Random random(21);
    std::size_t apart = 0, quick = 0, slow = 0;
    for (int i = 0; i < 30'000; ++i) {
        const glm::dvec3 corner = 3.0 * random.inCube();
        const glm::dvec3 right = random.inCube() * random.magnitude(-3, 0);
        const glm::dvec3 up = random.inCube() * random.magnitude(-3, 0);
        const bool directional = random.below(3) == 0;
        const glm::dvec4 light(random.inCube() * (directional ? 1.0 : random.magnitude(-2, 2)),
                               !directional);
        const NearClipVolume pyramid{{{corner, corner + right, corner + right + up, corner + up}},
                                     light};
        // A point of the hull, and a small box that contains it.
        const double s = random.uniform(0, 1), t = random.uniform(0, 1);
        const glm::dvec3 base = corner + s * right + t * up;
        const double u = random.uniform(0, 1);
        const glm::dvec3 point = directional ? base + u * 50.0 * glm::dvec3(light)
                                             : glm::mix(base, glm::dvec3(light), u);
        const double size = random.magnitude(-4, 0);
        const glm::dvec3 offset = size * random.inCube();
        EXPECT_FALSE(areApart(pyramid, boxAround(point + offset, size * 1.0001)));
        const ClipVolumeFaces faces(pyramid);
        EXPECT_FALSE(faces.separate(boxAround(point + offset, size * 1.0001)));
        const glm::dvec3 a = point + size * random.inCube(), b = point + size * random.inCube();
        const glm::dvec3 c = 3.0 * point - a - b; // so that the point is in its middle
        EXPECT_FALSE(areApart(pyramid, std::array{a, b, c}));
        EXPECT_FALSE(faces.separate(std::array{a, b, c}));
        // Boxes that the quick test separates, the slow one separates too.
        const std::array other = {4.0 * random.inCube(), 4.0 * random.inCube(),
                                  4.0 * random.inCube()};
        EXPECT_TRUE(directional || !faces.separate(other) || areApart(pyramid, other));
        quick += faces.separate(other);
        slow += areApart(pyramid, other);
        apart += areApart(pyramid, boxAround(4.0 * random.inCube(), size));
    }
    EXPECT_GT(apart, 10'000u); // a test that always says no would also pass
    EXPECT_GT(10 * quick, 8 * slow);
}

TEST(Touched, AreAllCapsThatMeetAVolumeAndFewOthers) {
    Random random(23);
    std::size_t meeting = 0, found = 0, all = 0;
    for (int i = 0; i < 40; ++i) {
        const PlanePairShadow shadow = scatteredCaps(1 + random.below(70 * leafTriangles), random);
        const auto size = static_cast<std::uint32_t>(shadow.caps.size());
        for (int k = 0; k < 10; ++k) {
            const CapRecord& near = shadow.caps[random.below(size)];
            const glm::dvec3 corner = glm::dvec3(near.a) + 0.1 * random.inCube();
            const glm::dvec3 right = 0.2 * random.inCube(), up = 0.2 * random.inCube();
            const NearClipVolume volume{
                {{corner, corner + right, corner + right + up, corner + up}},
                glm::dvec4(2.0 * random.inCube(), random.below(2))};
            const ClipVolumeFaces faces(volume);
            Touched touched;
            findTouching(faces, shadow.clusters[0], shadow, touched, size);
            EXPECT_FALSE(touched.tooMany);
            EXPECT_TRUE(std::ranges::is_sorted(touched.caps));
            bool any = false;
            for (std::uint32_t cap = 0; cap < size; ++cap) {
                const CapRecord& of = shadow.caps[cap];
                const std::array corners{glm::dvec3(of.a), glm::dvec3(of.b), glm::dvec3(of.c)};
                // Not all that is apart from a sun's volume has an axis that tells.
                if (faces.separate(corners) || areApart(volume, corners) ||
                    (volume.light.w == 0.0 && areApart(volume, shadow.leaves[cap / leafTriangles])))
                    continue;
                any = true;
                ++meeting;
                EXPECT_TRUE(std::ranges::binary_search(touched.caps, cap));
            }
            EXPECT_EQ(any, anyCapTouches(faces, shadow.clusters[0], shadow));
            found += touched.caps.size();
            all += size;
        }
    }
    EXPECT_GT(meeting, 10'000u);
    EXPECT_LT(found, meeting + (all - meeting) / 4);
}

TEST(VolumePlan, AnObjectInViewTakesNoCapsAndHalfTheTriangles) {
    const ClusterPlan draw = onlyDraw(clusterAt({0, 0, -10}, 1), {0, 50, -10, 1});
    EXPECT_EQ(draw.counted, Counted::lightFacing);
    EXPECT_FALSE(draw.zFail());
    EXPECT_FALSE(draw.frontCaps);
}

TEST(VolumePlan, AnOpenOneCountsInFull) {
    EXPECT_EQ(onlyDraw(clusterAt({0, 0, -10}, 1, false), {0, 50, -10, 1}).counted, Counted::all);
}

TEST(VolumePlan, TheEyeInItsShadowStartsTheCountAtOne) {
    for (const glm::dvec4& light : {glm::dvec4(0, 50, 0, 1), glm::dvec4(0, 1, 0, 0)}) {
        const ClusterPlan draw = onlyDraw(clusterAt({0, 5, 0}, 1), light);
        EXPECT_FALSE(draw.zFail());
        EXPECT_EQ(draw.counted, Counted::lightFacing);
        EXPECT_EQ(draw.start, 1);
        EXPECT_EQ(onlyDraw(clusterAt({0, 5, 0}, 1, false), light).start, 2)
            << "all triangles count";
    }
}

TEST(VolumePlan, AShadowsOutlineOverTheNearRectangleTakesCaps) {
    const ClusterPlan draw = onlyDraw(clusterAt({1.01, 5, 0}, 1), {0, 50, 0, 1});
    EXPECT_EQ(draw.caps, CapsNeeded::outlineMet);
    EXPECT_FALSE(draw.frontCaps) << "it is above the eye, out of view";
    EXPECT_EQ(draw.counted, Counted::lightFacing);
    // With a directional light in the plane of a face this is unknown.
    EXPECT_EQ(onlyDraw(clusterAt({1, 5, 0}, 1), {0, 1, 0, 0}).caps, CapsNeeded::uncertain);
}

// Shaders divide by the light's height above an end: for vertices whose w is a tiny share of
// others' a GPU clips a pixel off.
TEST(VolumePlan, EndsAreScaledToTheLightThatIsDrawn) {
    const FrameView view = viewAlongZ();
    FrameView placed = view;
    placed.visible = boxAround({0, 0, -10}, 5);
    for (const double length : {1e-30, 1.0, 1e30})
        for (const double scale : {1e-3, 1.0, 1e3}) {
            const glm::dmat4 worldFromBatch = glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
            const Light light{length * glm::dvec4(0.3, 1, 0.2, 0)};
            const PlanView planned = planView(placed, view.slices[0], light, worldFromBatch);
            ASSERT_FALSE(planned.ends.empty());
            const glm::dvec4 drawn(lightInObject(light, worldFromBatch));
            for (const glm::dvec4& end : planned.ends)
                EXPECT_NEAR(glm::dot(glm::dvec4(glm::vec4(end)), drawn), 1.0, 1e-4)
                    << length << " " << scale;
        }
}

TEST(VolumePlan, AddsUpStartsOfAllClusters) {
    const FrameView view = viewAlongZ();
    const std::vector<ShadowCluster> clusters = {clusterAt({0, 5, 0}, 1), clusterAt({0, 9, 0}, 1),
                                                 clusterAt({0, 0, -10}, 1)};
    const PlanView placed = planView(view, view.slices[0], {{0, 50, 0, 1}}, glm::dmat4(1.0));
    StencilStart start;
    start.add(planOf(clusters, placed));
    EXPECT_EQ(start.count(), 2);
}

TEST(VolumePlan, TheEyeBetweenLightAndObjectTakesNone) {
    EXPECT_FALSE(onlyDraw(clusterAt({0, 0, -10}, 1), {0, 0, 20, 1}).zFail());
}

TEST(VolumePlan, BetweenTheInsideAndTheOutsideItSealsTheLightOff) {
    const FrameView view = viewAlongZ();
    const auto planWith = [&](const ShadowCluster& cluster, const glm::dvec4& light) {
        const std::vector<ShadowCluster> clusters = {cluster, clusterAt({0, 0, -30}, 1)};
        return planOf(clusters, planView(view, view.slices[0], {light}, glm::dmat4(1.0)));
    };
    // The light is inside, or the eye, or both.
    EXPECT_EQ(planWith(clusterAt({0, 0, -10}, 1), {0, 0, -10.5, 1}).fullyShadowedBy, 0u);
    EXPECT_TRUE(planWith(clusterAt({0, 0, -10}, 1), {0, 0, -10.5, 1}).drawn.empty());
    EXPECT_EQ(planWith(clusterAt({0, 0, 0}, 3), {0, 50, -10, 1}).fullyShadowedBy, 0u);
    EXPECT_EQ(planWith(clusterAt({0, 0, 0}, 3), {0.3, 1, 0.2, 0}).fullyShadowedBy, 0u);
    EXPECT_FALSE(planWith(clusterAt({0, 0, 0}, 3), {0, 1, -1, 1}).fullyShadowedBy);
    // An open cluster, or one that the near plane cuts, proves nothing.
    EXPECT_FALSE(planWith(clusterAt({0, 0, -10}, 1, false), {0, 0, -10.5, 1}).fullyShadowedBy);
    EXPECT_FALSE(planWith(clusterAt({0, 0, -0.1}, 0.05), {0, 0, -0.12, 1}).fullyShadowedBy);
}

TEST(VolumePlan, ComponentsThatOneCrossesEachWayCountInFull) {
    // The eye is in one box, the light in another: their winding numbers must not be added.
    PlanePairShadow shadow;
    appendShell(boxAround({0, 0, 0}, 3), shadow.caps);
    appendShell(boxAround({0, 50, 0}, 3), shadow.caps);
    ShadowCluster cluster = clusterAt({0, 25, 0}, 30);
    cluster.caps = {0, 24};
    cluster.leaves = {0, 1};
    cluster.components = 2;
    shadow.leaves = {cluster.bounds};
    shadow.clusters = {cluster};
    const FrameView frame = viewAlongZ();
    const PlanView view = planView(frame, frame.slices[0], {{0.1, 50, 0.2, 1}}, glm::dmat4(1.0));
    const auto draws = test::planVolumes(shadow, view).drawn;
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].counted, Counted::all);
    EXPECT_EQ(draws[0].start, 2);
}

TEST(VolumePlan, TheNearPlaneWithinItsBoundsCountsInFull) {
    // The eye, at 0, is not inside; the near plane is at 0.1.
    const ClusterPlan draw = onlyDraw(clusterAt({0, 0, -0.1}, 0.05), {0, 50, -10, 1});
    EXPECT_EQ(draw.counted, Counted::all);
    EXPECT_EQ(draw.caps, CapsNeeded::nearPlaneMet);
    EXPECT_TRUE(draw.nearDiscard);
}

TEST(VolumePlan, WithinItsBoundsButBetweenItsTrianglesItTakesNoCapsAndHalfTheTriangles) {
    // Two plates, with the eye between them and the light beside it.
    PlanePairShadow shadow;
    Box left, right;
    left.add({-20, -20, -20});
    left.add({-19, 20, 20});
    right.add({19, -20, -20});
    right.add({20, 20, 20});
    ShadowCluster cluster = clusterAt({0, 0, 0}, 20);
    appendShell(left, shadow.caps);
    appendShell(right, shadow.caps);
    cluster.caps = {0, 24};
    cluster.leaves = {0, 1};
    shadow.leaves = {cluster.bounds};
    shadow.clusters = {cluster};
    const FrameView frame = viewAlongZ();
    const PlanView view = planView(frame, frame.slices[0], {{2, 3, -1, 1}}, glm::dmat4(1.0));
    auto draws = test::planVolumes(shadow, view).drawn;
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_FALSE(draws[0].zFail());
    EXPECT_EQ(draws[0].counted, Counted::lightFacing);
    // A box between the eye and the light.
    appendShell(boxAround({1, 1.5, -0.5}, 0.1), shadow.caps);
    shadow.clusters[0].caps.count = 36;
    shadow.clusters[0].leaves.count = 2;
    shadow.leaves.push_back(cluster.bounds);
    draws = test::planVolumes(shadow, view).drawn;
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_FALSE(draws[0].zFail());
    EXPECT_EQ(draws[0].start, 1);
    // If the components are unknown, one crossing in each direction may belong to two of them.
    shadow.clusters[0].components = 3;
    draws = test::planVolumes(shadow, view).drawn;
    EXPECT_EQ(draws[0].counted, Counted::all);
    EXPECT_EQ(draws[0].start, 2);
}

TEST(VolumePlan, ANearPlaneJustBeforeItTakesNoCapsAndHalfTheTriangles) {
    // As with fitted near planes: the rectangle reaches into the bounds, beside the triangles.
    PlanePairShadow shadow;
    ShadowCluster cluster = clusterAt({0, 0, -1}, 0.5);
    cluster.caps = {0, 1};
    cluster.leaves = {0, 1};
    shadow.leaves = {cluster.bounds};
    shadow.clusters = {cluster};
    shadow.caps = {{{-0.5f, -0.5f, -1.5f}, {0.5f, -0.5f, -1.5f}, {0.0f, 0.5f, -0.5f}, {}}};
    FrameView frame = viewAlongZ();
    frame.slices[0].near = 0.499;
    const auto draws = test::planVolumes(shadow, planView(frame, frame.slices[0], {{0, 50, 50, 1}},
                                                          glm::dmat4(1.0)))
                           .drawn;
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_FALSE(draws[0].zFail());
    EXPECT_EQ(draws[0].counted, Counted::lightFacing);
}

TEST(VolumePlan, WithHolesItAlwaysTakesCaps) {
    EXPECT_TRUE(onlyDraw(clusterAt({0, 0, -10}, 1, false, true), {0, 50, -10, 1}).zFail());
}

TEST(VolumePlan, WhatIsBesideEverythingVisibleIsLeftOut) {
    FrameView view = viewAlongZ();
    view.visible = boxAround({0, -2, -10}, 1.0);
    const glm::dmat4 placed = glm::translate(glm::dmat4(1.0), glm::dvec3(1, 2, 3));
    for (const glm::dvec4& light : {glm::dvec4(0.1, 1, 0.1, 0), glm::dvec4(0, 30, -10, 1)}) {
        const PlanView inWorld = planView(view, view.slices[0], {light}, glm::dmat4(1.0));
        std::vector<glm::dvec4> between, inBatch;
        findPlanesBetween(view, {light}, between);
        PlanView place = planView(view, view.slices[0], {light}, placed);
        for (const glm::dvec4& plane : between)
            inBatch.push_back(glm::transpose(placed) * plane);
        // Volumes of both run through the view; only those of the first run through the box.
        for (const double z : {-10.0, -20.0}) {
            const ShadowCluster cluster = clusterAt(glm::dvec3(0, 3, z) - glm::dvec3(1, 2, 3), 1.0);
            PlanePairShadow shadow;
            shadow.clusters = {cluster};
            place.between = {};
            EXPECT_EQ(planFor({cluster}, place).size(), 1u);
            place.between = inBatch;
            const VolumePlan plan = planOf({cluster}, place);
            const auto whole = leftOutWhole(shadow, placed, inWorld, inBatch);
            if (z == -10.0) {
                EXPECT_EQ(plan.drawn.size(), 1u);
                EXPECT_FALSE(whole);
                continue;
            }
            ASSERT_EQ(plan.leftOut.size(), 1u);
            EXPECT_EQ(plan.leftOut[0].why, LeftOut::Why::besideVisible);
            ASSERT_TRUE(whole);
            EXPECT_EQ(whole->why, LeftOut::Why::besideVisible);
        }
    }
    view.visible = {};
    std::vector<glm::dvec4> none{glm::dvec4(1.0)};
    findPlanesBetween(view, {{0, 1, 0, 0}}, none);
    EXPECT_TRUE(none.empty());
}

TEST(VolumePlan, WhatNearlyTouchesTheVisibleBoxStays) {
    // Depths, and so the box, are rounded, by as much as the coordinates are.
    FrameView view = viewAlongZ();
    std::vector<glm::dvec4> between;
    for (const glm::dvec3& at : {glm::dvec3(0, -2, -10), glm::dvec3(0, -2e6, -1e7)}) {
        view.visible = boxAround(at, 1.0);
        findPlanesBetween(view, {{0, 1, 0, 0}}, between);
        const auto isBeside = [&](double x) {
            const Box box = boxAround(at + glm::dvec3(x, 3, 0), 1.0);
            return std::any_of(between.begin(), between.end(),
                               [&](const glm::dvec4& plane) { return isOutside(box, plane); });
        };
        const double rounding = 1e-7 * glm::length(at);
        EXPECT_FALSE(isBeside(2.0 + rounding));
        EXPECT_FALSE(isBeside(-2.0 - rounding));
        EXPECT_TRUE(isBeside(2.1 + 100.0 * rounding));
        EXPECT_TRUE(isBeside(-2.1 - 100.0 * rounding));
    }
}

TEST(VolumePlan, WhatCannotCastIntoTheViewIsLeftOut) {
    EXPECT_TRUE(planFor(clusterAt({0, 0, 10}, 1), {0, 50, 10, 1}).empty());   // behind the eye
    EXPECT_TRUE(planFor(clusterAt({50, 0, -10}, 1), {0, 0, -10, 1}).empty()); // to the right
    EXPECT_TRUE(
        planFor(clusterAt({50, 0, -10}, 1), {-1, 0, 0, 0}).empty()); // with a directional light
    EXPECT_TRUE(planFor(clusterAt({0, 0, -200}, 1), {0, 0, 10, 1}).empty());    // beyond all
    EXPECT_EQ(planFor(clusterAt({50, 0, -10}, 1), {90, 0, -10, 1}).size(), 1u); // the shadow comes
                                                                                // in from outside
    EXPECT_EQ(planFor(clusterAt({0, 0, 10}, 1), {0, 0, 50, 1}).size(), 1u);
}

TEST(VolumePlan, NeighboursThatAreDrawnAlikeShareADraw) {
    const FrameView view = viewAlongZ();
    const std::vector<ShadowCluster> clusters = {
        clusterAt({0, 0, -10}, 1), clusterAt({3, 0, -10}, 1), clusterAt({0, 0, 10}, 1),
        clusterAt({0, 3, -10}, 1), clusterAt({1, 1, -10}, 1, false)};
    const auto draws =
        planFor(clusters, planView(view, view.slices[0], {{0, 50, -10, 1}}, glm::dmat4(1.0)));
    ASSERT_EQ(draws.size(), 3u);
    EXPECT_EQ(draws[0].clusters.first, 0u);
    EXPECT_EQ(draws[0].clusters.count, 2u);
    EXPECT_EQ(draws[1].clusters.first, 3u);
    EXPECT_EQ(draws[1].clusters.count, 1u);
    EXPECT_EQ(draws[2].counted, Counted::all);
}

TEST(VolumePlan, NoShadowInViewIsLeftOutAndNoEyeInAShadowGoesWithoutCaps) {
    Random random(8);
    const FrameView view = viewAlongZ();
    std::size_t leftOut = 0, withoutCaps = 0, inShadow = 0, sealed = 0, withoutBackCaps = 0;
    for (int i = 0; i < 30'000; ++i) {
        const bool directional = random.below(3) == 0;
        const glm::dvec4 light(random.inCube() * (directional ? 1.0 : random.magnitude(-1, 2)),
                               !directional);
        const ShadowCluster cluster =
            clusterAt(random.inCube() * random.magnitude(-1, 2), random.magnitude(-2, 1));
        const std::vector<ShadowCluster> clusters = {cluster};
        const VolumePlan plan =
            planOf(clusters, planView(view, view.slices[0], {light}, glm::dmat4(1.0)));
        const auto& draws = plan.drawn;
        // A point of the cluster's volume.
        const glm::dvec3 of = cluster.bounds.center() +
                              random.inCube() * (0.5 * (cluster.bounds.high - cluster.bounds.low));
        const double away = random.magnitude(-3, 3);
        const glm::dvec3 point =
            of + away * (directional ? -glm::dvec3(light) : of - glm::dvec3(light));
        const double depth = -point.z, reach = depth * std::tan(glm::radians(30.0));
        const bool inView =
            depth > 0.1 && depth < 100.0 && std::abs(point.x) < reach && std::abs(point.y) < reach;
        leftOut += !plan.leftOut.empty();
        EXPECT_FALSE(!plan.leftOut.empty() && inView);
        // Whether the middle of the near plane sees the light through the box.
        const glm::dvec3 near(0, 0, -0.1);
        const glm::dvec3 towards = directional ? glm::dvec3(light) : glm::dvec3(light) - near;
        double enter = 0.0, leave = directional ? 1e30 : 1.0;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
            const double a = (cluster.bounds.low[axis] - near[axis]) / towards[axis];
            const double b = (cluster.bounds.high[axis] - near[axis]) / towards[axis];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        if (plan.fullyShadowedBy) {
            ++sealed;
            EXPECT_TRUE((enter == 0.0) != (leave == (directional ? 1e30 : 1.0)));
        }
        if (draws.empty()) continue;
        withoutCaps += !draws[0].zFail();
        // The number of crossings of the shell, from outside and from inside.
        const int in = enter <= leave && enter > 0.0;
        const int out = enter <= leave && leave < (directional ? 1e30 : 1.0);
        inShadow += in + out > 0 && !draws[0].zFail();
        if (draws[0].zFail()) {
            const glm::dvec3 infinite = of - glm::dvec3(light);
            const double wide = -infinite.z * std::tan(glm::radians(30.0));
            const bool shown = std::abs(infinite.x) < wide && std::abs(infinite.y) < wide;
            withoutBackCaps += !directional && !draws[0].backCaps;
            EXPECT_FALSE(!directional && !draws[0].backCaps && shown);
            continue;
        }
        EXPECT_EQ(draws[0].start, draws[0].counted == Counted::all ? in + out : out);
    }
    EXPECT_GT(leftOut, 1'000u);
    EXPECT_GT(withoutCaps, 1'000u);
    EXPECT_GT(inShadow, 150u);
    EXPECT_GT(sealed, 100u);
    EXPECT_GT(withoutBackCaps, 100u);
}

TEST(VolumePlan, CastersWithHolesTakeNoFans) {
    const auto draws = planFor(clusterAt({0, 0, -5}, 0.5, false, true), {2, 9, -3, 1});
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_EQ(draws[0].caps, CapsNeeded::seenThrough);
    EXPECT_TRUE(draws[0].frontCaps);
    EXPECT_FALSE(draws[0].nearDiscard);
    EXPECT_FALSE(draws[0].fannedCaps);
}

TEST(VolumePlan, EndsHaveTheEyeAndAllThatIsVisibleOnTheLightsSide) {
    Random random(12);
    std::size_t ends = 0;
    for (int i = 0; i < 5'000; ++i) {
        FrameView view = viewAlongZ();
        const glm::dvec3 from = 20.0 * random.inCube();
        view.frustum = frustumOf({from, from + random.inCube(), 60.0}, 1.0);
        const glm::dvec3 middle = 10.0 * random.inCube();
        view.visible = boxAround(middle, random.magnitude(-1, 1));
        view.farthestDepth = 100.0;
        glm::dmat4 placed(1.0);
        placed[0] = {-2, 0.3, 0, 0};
        placed[3] = {random.uniform(-5, 5), 1, 2, 1};
        const bool directional = random.below(3) == 0;
        const Light light{glm::dvec4(30.0 * random.inCube(), !directional)};
        const PlanView here = planView(view, view.slices[0], light, placed);
        for (const glm::dvec4& end : here.ends) {
            ++ends;
            EXPECT_NEAR(glm::dot(end, here.light), 1.0, 1e-9);
            EXPECT_GT(glm::dot(end, here.eye), 0.0);
            for (const glm::dvec3& corner : here.fromNear.corners)
                EXPECT_GT(glm::dot(end, glm::dvec4(corner, 1.0)), 0.0);
            if (&end == &here.ends.front())
                continue; // at the farthest depth, if the light is nearer
            for (const double s : {0.0, 1.0}) {
                const glm::dvec3 seen = glm::mix(view.visible.low, view.visible.high, s);
                EXPECT_GT(glm::dot(end, glm::inverse(placed) * glm::dvec4(seen, 1.0)), 0.0);
            }
        }
    }
    EXPECT_GT(ends, 10'000u);
}

TEST(VolumePlan, IsTheSameInTheSpaceOfAMovedNode) {
    const glm::dvec4 light(0, 50, -10, 1);
    glm::dmat4 worldFromBatch(1.0);
    worldFromBatch[0] = {-2, 0, 0, 0}; // mirrored, stretched
    worldFromBatch[3] = {0, 0, -10, 1};
    const auto draws = planFor(clusterAt({0, 0, 0}, 0.5), light, worldFromBatch);
    ASSERT_EQ(draws.size(), 1u);
    EXPECT_FALSE(draws[0].zFail());
    EXPECT_EQ(draws[0].counted, Counted::lightFacing);
    EXPECT_TRUE(planFor(clusterAt({0, 0, 20}, 0.5), light, worldFromBatch).empty());
}

TEST(VolumePlan, ClustersOutOfALightsRangeAreLeftOut) {
    const FrameView view = viewAlongZ();
    const auto draws = [&](double range, const glm::dmat4& worldFromBatch = glm::dmat4(1.0)) {
        const Light light{{0, 0, -10, 1}, range};
        // 1, 4 and 9 away from the light, on its far side and to both sides.
        const std::vector<ShadowCluster> clusters = {clusterAt({0, 0, -11.5}, 0.5),
                                                     clusterAt({4.5, 0, -10}, 0.5),
                                                     clusterAt({-9.5, 0, -20}, 0.5)};
        std::uint32_t count = 0;
        for (const ClusterPlan& draw :
             planFor(clusters, planView(view, view.slices[0], light, worldFromBatch)))
            count += draw.clusters.count;
        return count;
    };
    EXPECT_EQ(draws(0.9), 0u);
    EXPECT_EQ(draws(1.1), 1u);
    EXPECT_EQ(draws(3.9), 1u);
    EXPECT_EQ(draws(4.1), 2u);
    EXPECT_EQ(draws(20.0), 3u);
    EXPECT_EQ(draws(std::numeric_limits<double>::infinity()), 3u);
    // In a batch of twice the scale everything is half as far from the light, which is at z = -5.
    EXPECT_GT(draws(20.0, glm::dmat4(glm::dmat3(2.0))), 0u);
    EXPECT_EQ(draws(5.0, glm::dmat4(glm::dmat3(2.0))), 0u);
}

// A fan's triangles are pushed away from the light like the triangles that they replace: around a
// light within the cluster they would close on its wrong side.
TEST(VolumePlan, BackCapsAreNoFansAroundALightWithinTheCluster) {
    const glm::dvec4 light(0, 0, -20, 1);
    const auto drawWithBounds = [&](const Box& bounds) {
        // A shell whose silhouette crosses the rays from the near rectangle to the light.
        PlanePairShadow shadow;
        appendShell(boxAround({0.5, 0, -10}, 0.5), shadow.caps);
        ShadowCluster cluster;
        cluster.bounds = bounds;
        cluster.caps = {0, 12};
        cluster.leaves = {0, 1};
        shadow.leaves.push_back(bounds);
        shadow.clusters.push_back(cluster);
        const FrameView view = viewAlongZ();
        const auto draws =
            test::planVolumes(shadow, planView(view, view.slices[0], {light}, glm::dmat4(1.0)))
                .drawn;
        EXPECT_EQ(draws.size(), 1u);
        return draws.empty() ? ClusterPlan() : draws.front();
    };
    const ClusterPlan around = drawWithBounds(boxAround({0, 0, -16}, 6.0));
    EXPECT_TRUE(around.zFail());
    EXPECT_TRUE(around.backCaps);
    EXPECT_FALSE(around.nearDiscard);
    EXPECT_FALSE(around.fannedCaps);
    const ClusterPlan apart = drawWithBounds(boxAround({0, 0, -10}, 2.0));
    EXPECT_TRUE(apart.zFail());
    EXPECT_TRUE(apart.fannedCaps);
}

} // namespace edgeshade
