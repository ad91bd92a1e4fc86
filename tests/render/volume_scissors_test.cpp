// Rectangles around what is visible of shadows (docs/method.md, C45), without a GL: depth buffers
// are made up.
#include "src/shadow/scissors/cluster_scissors.hpp"
#include "src/shadow/scissors/scissored_plan.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/placed_shadows.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::Random;

constexpr int width = 90, height = 62; // no whole blocks
constexpr PixelRectangle whole{0, 0, width, height};
constexpr double aspect = static_cast<double>(width) / height;

/// A scene, a view of it, and a plan of its volumes.
struct Planned {
    Scene scene;
    FrameView view;
    PotentialSilhouettes silhouettes{23};
    CountPlan plan;

    Planned(const Scene& of, const Frustum& frustum, const Light& light)
        : scene(of),
          view(makeFrameView(scene, false, {frustum, width, height, {light}, {0.1, 1}})) {
        view.divide(1);
        PlanSettings settings;
        settings.silhouettes = &silhouettes;
        silhouettes.beginFrame(nullptr);
        plan = planCount(test::placedShadows(scene), scene.materials, view, view.slices.front(), 0,
                         settings);
    }
    const Light& light() const { return view.lights.front().light; }
    const DepthSlice& slice() const { return view.slices.front(); }
    VisiblePoints visible(const DepthPicture& depths, const PixelRectangle& reach = whole) const {
        return VisiblePoints(depths, view, slice(), light(), reach);
    }
};

/// A depth buffer with the points of some pixels, in the world.
struct MadeUp {
    DepthPicture depths{width, height, 24, std::vector<std::uint32_t>(width* height, ~0u)};
    struct Point {
        int x, y;
        glm::dvec3 at;
    };
    std::vector<Point> points;

    void add(const FrameView& view, const DepthSlice& slice, int x, int y, double depth) {
        const glm::dmat4 clip = view.clipFromView(slice);
        const glm::dvec4 inClip = clip * glm::dvec4(0, 0, -depth, 1);
        const double buffered =
            std::floor((0.5 + 0.5 * inClip.z / inClip.w) * 16777215.0 + 0.5); // 24 bits
        if (buffered < 0.0 || buffered > 16777214.0) return;
        const auto bits = static_cast<std::uint32_t>(buffered);
        depths.depths[static_cast<std::size_t>(y * width + x)] = bits << 8 | bits >> 16;
        const glm::dvec2 point(2.0 * (x + 0.5) / width - 1.0, 2.0 * (y + 0.5) / height - 1.0);
        const bool flat = view.frustum.orthographic;
        const glm::dvec2 window = view.frustum.windowAt(point) * (flat ? 1.0 : depth);
        points.push_back({x, y,
                          glm::dvec3(glm::inverse(view.frustum.viewFromWorld) *
                                     glm::dvec4(window, -depth, 1.0))});
    }
};

/// Points here and there, some side by side, as surfaces have them.
MadeUp randomDepths(const Planned& planned, Random& random) {
    MadeUp made;
    const DepthSlice& slice = planned.slice();
    const double farthest = planned.view.farthestDepth;
    for (int patch = 0; patch < 12; ++patch) {
        const int x = random.below(width), y = random.below(height), size = 1 + random.below(12);
        const double depth = random.uniform(1.001 * slice.near, farthest);
        const double slope = random.uniform(-0.02, 0.02) * depth;
        for (int j = y; j < std::min(height, y + size); ++j)
            for (int i = x; i < std::min(width, x + size); ++i)
                made.add(planned.view, slice, i, j,
                         std::clamp(depth + slope * (i - x), 1.001 * slice.near, farthest));
    }
    return made;
}

/// Whether the segment from a point to the light meets the triangle, the point a share off it.
bool isShadowed(const glm::dvec3& point, const Light& light, const CapRecord& cap) {
    const glm::dvec3 a(cap.a), ab = glm::dvec3(cap.b) - a, ac = glm::dvec3(cap.c) - a;
    const bool sun = light.position.w == 0.0;
    const glm::dvec3 way = sun ? glm::dvec3(light.position) : glm::dvec3(light.position) - point;
    const glm::dvec3 normal = glm::cross(way, ac);
    const double det = glm::dot(ab, normal);
    if (std::abs(det) < 1e-12) return false;
    const double u = glm::dot(point - a, normal) / det;
    const glm::dvec3 other = glm::cross(point - a, ab);
    const double v = glm::dot(way, other) / det, t = glm::dot(ac, other) / det;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 && (sun || t <= 1.0);
}

bool holds(const PixelRectangle& rectangle, int x, int y) {
    return x >= rectangle.x && x < rectangle.x + rectangle.width && y >= rectangle.y &&
           y < rectangle.y + rectangle.height;
}

/// Triangles and boxes here and there.
Scene clutter(Random& random, double far) {
    test::SceneBuilder builder;
    const glm::dvec3 middle(far, -0.5 * far, 0.25 * far);
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 at = middle + 4.0 * random.inCube();
        if (i % 3 != 0) {
            builder.box(glm::vec3(at), glm::vec3(at + glm::dvec3(0.2, 0.5, 0.3)));
            continue;
        }
        builder.triangle(glm::vec3(at), glm::vec3(at + random.inCube()),
                         glm::vec3(at + random.inCube()));
    }
    return builder.scene();
}

Frustum someFrustum(Random& random, double far, bool orthographic) {
    const glm::dvec3 middle(far, -0.5 * far, 0.25 * far);
    const Camera camera{middle + 7.0 * random.inCube(), middle, 50.0};
    return frustumOf(camera, aspect, orthographic ? std::optional(8.0) : std::nullopt);
}

/// Orthographic pictures take suns alone.
Light someLight(Random& random, double far, bool orthographic) {
    const glm::dvec3 way = random.inCube();
    if (orthographic || random.below(2) == 0) return {glm::dvec4(way, 0.0)};
    const glm::dvec3 middle(far, -0.5 * far, 0.25 * far);
    return {glm::dvec4(middle + 6.0 * way, 1.0)};
}

TEST(VolumeScissors, HoldEveryPointThatIsInAVolume) {
    Random random(17);
    std::size_t shadowed = 0, around = 0, clusters = 0;
    for (int i = 0; i < 90; ++i) {
        SCOPED_TRACE(i);
        const double far = i % 4 == 3 ? 3000.0 : 0.0;
        const bool orthographic = i % 3 == 1;
        const Planned planned(clutter(random, far), someFrustum(random, far, orthographic),
                              someLight(random, far, orthographic));
        const MadeUp made = randomDepths(planned, random);
        const VisiblePoints visible = planned.visible(made.depths);
        for (const BatchPlan& batch : planned.plan.batches) {
            const ClusterScissors scissors(batch, visible);
            for (const ShadowCluster& cluster : batch.shadow->clusters) {
                const PixelRectangle scissor = scissors.of(cluster);
                ++clusters;
                around += static_cast<std::size_t>(scissor.width) *
                          static_cast<std::size_t>(scissor.height);
                for (std::uint32_t c = cluster.caps.first; c < cluster.caps.end(); ++c)
                    for (const MadeUp::Point& point : made.points) {
                        if (!isShadowed(point.at, planned.light(), batch.shadow->caps[c])) continue;
                        ++shadowed;
                        EXPECT_TRUE(holds(scissor, point.x, point.y))
                            << point.x << ", " << point.y << " beside " << scissor.x << ", "
                            << scissor.y << ", " << scissor.width << " x " << scissor.height;
                    }
            }
        }
    }
    EXPECT_GT(shadowed, 4000u);
    EXPECT_LT(around, clusters * width * height * 9 / 10); // or it would say nothing
}

TEST(VolumeScissors, LeaveOutWhatShadowsNothingThatIsSeen) {
    const Scene scene = test::SceneBuilder().floor(10).box({-6, 2, -1}, {-4, 3, 1}).scene();
    Planned planned(scene, frustumOf({{4, 6, 8}, {4, 0, 0}, 40.0}, aspect), {{0.2, 1, 0.1, 0}});
    // All that is seen is the floor, in the right half.
    MadeUp made;
    for (int y = 0; y < height; ++y)
        for (int x = width / 2; x < width; ++x) {
            const glm::dvec2 point(2.0 * (x + 0.5) / width - 1.0, 2.0 * (y + 0.5) / height - 1.0);
            const glm::dvec3 way = glm::inverse(glm::dmat3(planned.view.frustum.viewFromWorld)) *
                                   glm::dvec3(planned.view.frustum.windowAt(point), -1.0);
            if (way.y < -0.1) made.add(planned.view, planned.slice(), x, y, -6.0 / way.y);
        }
    ASSERT_GT(made.points.size(), 500u);
    const std::size_t before = planned.plan.vertexRuns();
    scissorPlan(planned.plan, planned.visible(made.depths), scene.materials, planned.view,
                planned.slice(), FillWeights());
    EXPECT_LT(planned.plan.vertexRuns(), before);
    std::uint32_t leftOut = 0;
    for (const LeftOut& left : planned.plan.batches.front().volumes.leftOut)
        if (left.why == LeftOut::Why::noReceiver) leftOut += left.clusters.count;
    EXPECT_EQ(leftOut, 1u); // the box; the floor may be in its own shadow
    for (const auto* draws : {&planned.plan.draws.once, &planned.plan.draws.twice})
        for (const VolumeDraw& draw : *draws) {
            ASSERT_TRUE(draw.scissor);
            EXPECT_GE(draw.scissor->x, width / 2 - VisiblePoints::blockSize);
        }
}

TEST(VolumeScissors, StayWithinReach) {
    Random random(4);
    Planned planned(clutter(random, 0.0), someFrustum(random, 0.0, false), {{0.3, 1, 0.2, 0}});
    const MadeUp made = randomDepths(planned, random);
    const PixelRectangle reach{11, 7, 50, 33};
    scissorPlan(planned.plan, planned.visible(made.depths, reach), planned.scene.materials,
                planned.view, planned.slice(), FillWeights());
    for (const auto* draws : {&planned.plan.draws.once, &planned.plan.draws.twice})
        for (const VolumeDraw& draw : *draws)
            EXPECT_EQ(intersection(*draw.scissor, reach), *draw.scissor);
}

TEST(VolumeScissors, OfVolumesThatTheEyeIsInAreNone) {
    const Scene scene = test::SceneBuilder().floor(9).box({-1, 4, -1}, {1, 5, 1}).scene();
    Planned planned(scene, frustumOf({{0, 2, 0}, {0.2, 0, 3}, 50.0}, aspect), {{0, 40, 0, 1}});
    ASSERT_NE(planned.plan.start.count(), 0);
    MadeUp made; // of one pixel
    made.add(planned.view, planned.slice(), 3, 3, 0.7 * planned.view.farthestDepth);
    scissorPlan(planned.plan, planned.visible(made.depths), scene.materials, planned.view,
                planned.slice(), FillWeights());
    int start = 0;
    for (const ClusterPlan& drawn : planned.plan.batches.front().volumes.drawn) {
        EXPECT_EQ(drawn.scissor.has_value(), drawn.start == 0);
        start += drawn.start;
    }
    EXPECT_EQ(start, planned.plan.start.count());
}

TEST(VolumeScissors, ClustersShareOneWhereDrawsCostMore) {
    Random random(8);
    test::SceneBuilder builder;
    builder.floor(9);
    for (int i = 0; i < 400; ++i) {
        const glm::vec3 at(glm::dvec3(3.0, 0.6, 3.0) * random.inCube() + glm::dvec3(0, 1, 0));
        builder.box(at, at + glm::vec3(0.1f));
    }
    const Frustum frustum = frustumOf({{6, 5, 7}, {0, 0, 0}, 45.0}, aspect);
    const auto drawsOf = [&](double costOfDraw) {
        Planned planned(builder.scene(), frustum, {{0.4, 1, 0.3, 0}});
        Random again(2);
        const MadeUp made = randomDepths(planned, again);
        FillWeights weights;
        weights.draw = costOfDraw;
        scissorPlan(planned.plan, planned.visible(made.depths), planned.scene.materials,
                    planned.view, planned.slice(), weights);
        return planned.plan.batches.front().volumes.drawn.size();
    };
    EXPECT_GT(drawsOf(0.0), drawsOf(1e9));
}

} // namespace
} // namespace edgeshade
