// Tests of single points for whether a light reaches them (docs/method.md, C46), without a GL: rays
// make the pictures.
#include "src/shadow/irregular/irregular_z_buffer.hpp"
#include "tests/support/bounded_frame.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <set>

namespace edgeshade {
namespace {

using test::Random;

constexpr int width = 93, height = 61; // not a multiple of a block
constexpr double aspect = static_cast<double>(width) / height;
constexpr PixelRectangle whole{0, 0, width, height};
constexpr std::uint32_t firstNumber = 7;

struct Triangle {
    glm::dvec3 a, b, c;
};

std::vector<Triangle> trianglesOf(const Scene& scene) {
    std::vector<Triangle> triangles;
    const Geometry& geometry = *scene.batches.front().geometry;
    const auto at = [&](std::size_t i) { return glm::dvec3(geometry.positions[i]); };
    for (std::size_t i = 0; i < geometry.indices.size(); i += 3)
        triangles.push_back(
            {at(geometry.indices[i]), at(geometry.indices[i + 1]), at(geometry.indices[i + 2])});
    return triangles;
}

/// Where a ray meets a triangle's plane, and how far inside the triangle; below 0 outside.
struct Hit {
    double t = 0.0, within = -1.0;
};

Hit hit(const glm::dvec3& from, const glm::dvec3& way, const Triangle& triangle) {
    const glm::dvec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
    const glm::dvec3 normal = glm::cross(way, ac);
    const double det = glm::dot(ab, normal);
    if (std::abs(det) < 1e-12) return {};
    const double u = glm::dot(from - triangle.a, normal) / det;
    const glm::dvec3 other = glm::cross(from - triangle.a, ab);
    const double v = glm::dot(way, other) / det;
    return {glm::dot(ac, other) / det, std::min({u, v, 1.0 - u - v})};
}

/// The surface that a pixel shows.
struct Seen {
    int triangle = -1; ///< -1: nothing, or too near an edge to decide
    glm::dvec3 at{0.0};
};

struct Picture {
    Scene scene;
    FrameView view;
    std::vector<Triangle> triangles;
    SeenTriangles shown{whole, std::vector<std::uint32_t>(width* height, 0), {}};
    std::vector<std::uint8_t> casts;
    std::vector<Seen> seen{width * height};

    Picture(const Scene& of, const Frustum& frustum, const Light& light)
        : scene(of), view(test::boundedFrame(scene, false,
                                             {frustum, width, height, {light}, {std::nullopt, 1}})),
          triangles(trianglesOf(of)), casts(triangles.size(), 1) {
        view.divide(1);
        const Batch& batch = scene.batches.front();
        shown.surfaces = {{batch.geometry->positions, batch.geometry->indices, casts,
                           batch.worldFromBatch, firstNumber}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                look(x, y);
    }

    std::vector<std::uint8_t> shadowed(const PixelRectangle& reach, Threads threads) const {
        IrregularZBuffer buffer(shown, view, view.lights.front().light, reach, threads);
        const Geometry& geometry = *scene.batches.front().geometry;
        const CasterRuns runs(geometry.positions, geometry.indices);
        const PlacedRuns placed{&runs, scene.batches.front().worldFromBatch};
        buffer.cast(std::span(&placed, 1), threads);
        return buffer.shadowed();
    }

    /// 1: something is between the visible point and the light; 0: nothing is; -1: too close to
    /// decide.
    int answer(const Seen& of) const {
        const glm::dvec4& light = view.lights.front().light.position;
        const bool sun = light.w == 0.0;
        const glm::dvec3 way = sun ? glm::dvec3(light) : glm::dvec3(light) - of.at;
        int answer = turnsAway(of, way);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            if (static_cast<int>(i) == of.triangle) continue;
            const Hit met = hit(of.at, way, triangles[i]);
            constexpr double room = 1e-3;
            if (met.within < -room || met.t < -room || (!sun && met.t > 1.0 + room)) continue;
            if (met.within < room || met.t < room || (!sun && met.t > 1.0 - room)) return -1;
            answer = 1;
        }
        return answer;
    }

  private:
    glm::dvec3 eyeTo(const glm::dvec3& at) const {
        const glm::dvec4 eye = view.frustum.eye();
        return eye.w == 0.0 ? -glm::dvec3(eye) : at - glm::dvec3(eye);
    }

    /// 1 if eye and light are on different sides of the visible triangle, -1 if one is in its
    /// plane.
    int turnsAway(const Seen& of, const glm::dvec3& way) const {
        const Triangle& own = triangles[static_cast<std::size_t>(of.triangle)];
        const glm::dvec3 normal = glm::normalize(glm::cross(own.b - own.a, own.c - own.a));
        const double light = glm::dot(normal, glm::normalize(way));
        const double eye = -glm::dot(normal, glm::normalize(eyeTo(of.at)));
        if (std::abs(light) < 0.02 || std::abs(eye) < 0.02) return -1;
        return (light > 0.0) == (eye > 0.0) ? 0 : 1;
    }

    void look(int x, int y) {
        const glm::dmat4 world = glm::inverse(view.frustum.viewFromWorld);
        const glm::dvec2 point(2.0 * (x + 0.5) / width - 1.0, 2.0 * (y + 0.5) / height - 1.0);
        const glm::dvec2 window = view.frustum.windowAt(point);
        const bool flat = view.frustum.orthographic;
        const glm::dvec3 from(world * glm::dvec4(flat ? window : glm::dvec2(0.0), 0.0, 1.0));
        const glm::dvec3 way(world * glm::dvec4(flat ? glm::dvec2(0.0) : window, -1.0, 0.0));
        double nearest = std::numeric_limits<double>::infinity();
        Seen of;
        bool sure = true;
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Hit met = hit(from, way, triangles[i]);
            if (met.within < -1e-3 || met.t < view.near() || met.t >= nearest) continue;
            sure = met.within > 1e-3;
            nearest = met.t;
            of = {static_cast<int>(i), from + met.t * way};
        }
        if (of.triangle < 0) return;
        const auto pixel = static_cast<std::size_t>(y * width + x);
        shown.numbers[pixel] = firstNumber + static_cast<std::uint32_t>(of.triangle);
        if (sure) seen[pixel] = of;
    }
};

/// Scattered triangles and boxes, and a large triangle beneath.
Scene clutter(Random& random) {
    test::SceneBuilder builder;
    builder.floor(9, -3);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 at = 3.0 * random.inCube();
        if (i % 3 != 0)
            builder.box(glm::vec3(at), glm::vec3(at + glm::dvec3(0.2, 0.5, 0.3)));
        else
            builder.triangle(glm::vec3(at), glm::vec3(at + random.inCube()),
                             glm::vec3(at + random.inCube()));
    }
    return builder.scene();
}

Frustum someFrustum(Random& random, bool orthographic) {
    const Camera camera{6.0 * random.inCube(), random.inCube(), 60.0};
    return frustumOf(camera, aspect, orthographic ? std::optional(8.0) : std::nullopt);
}

Light someLight(Random& random, bool orthographic) {
    const glm::dvec3 way = random.inCube();
    if (orthographic || random.below(2) == 0) return {glm::dvec4(way, 0.0)};
    return {glm::dvec4(random.below(4) == 0 ? 1e7 * way : 4.0 * way, 1.0)};
}

TEST(IrregularZBuffer, SaysOfEveryPointWhatRaysSay) {
    Random random(5);
    int lit = 0, dark = 0;
    for (int i = 0; i < 40; ++i) {
        SCOPED_TRACE(i);
        const bool orthographic = i % 5 == 4;
        const Picture picture(clutter(random), someFrustum(random, orthographic),
                              someLight(random, orthographic));
        const auto shadowed = picture.shadowed(whole, {1});
        for (std::size_t pixel = 0; pixel < picture.seen.size(); ++pixel) {
            const Seen& of = picture.seen[pixel];
            const int answer = of.triangle < 0 ? -1 : picture.answer(of);
            if (answer < 0) continue;
            EXPECT_EQ(shadowed[pixel], answer == 1 ? 255 : 0)
                << pixel % width << ", " << pixel / width;
            ++(answer == 1 ? dark : lit);
        }
    }
    EXPECT_GT(lit, 20'000);
    EXPECT_GT(dark, 20'000);
}

TEST(IrregularZBuffer, SaysTheSameForAnyNumberOfThreads) {
    Random random(6);
    const Picture picture(clutter(random), someFrustum(random, false), {glm::dvec4(1, 2, 3, 1)});
    EXPECT_EQ(picture.shadowed(whole, {1}), picture.shadowed(whole, {5}));
}

TEST(IrregularZBuffer, AsksNothingBeyondItsReach) {
    Random random(7);
    const Picture picture(clutter(random), frustumOf({{0, 2, 6}, {0, -1, 0}, 60.0}, aspect),
                          {glm::dvec4(0.3, 1, 0.2, 0)});
    const PixelRectangle reach{17, 9, 40, 31};
    const auto all = picture.shadowed(whole, {1}), some = picture.shadowed(reach, {1});
    std::size_t within = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto pixel = static_cast<std::size_t>(y * width + x);
            const bool inside = x >= reach.x && x < reach.x + reach.width && y >= reach.y &&
                                y < reach.y + reach.height;
            EXPECT_EQ(some[pixel], inside ? all[pixel] : 0);
            within += inside && all[pixel] != 0;
        }
    EXPECT_GT(within, 50u);
}

TEST(PointTree, FindsThePointsOfEveryHalfSpaceThatAreInTheBox) {
    Random random(8);
    for (const std::size_t count : {1u, 15u, 16u, 17u, 129u, 5000u}) {
        SCOPED_TRACE(count);
        std::vector<std::vector<FacePoint>> points(3);
        for (std::uint32_t i = 0; i < count; ++i)
            points[i % 3].push_back({glm::vec3(random.inCube()), Pixel(static_cast<int>(i), 7)});
        for (int turn = 0; turn < 20; ++turn) {
            PointTree tree;
            tree.build({}, points);
            const glm::vec3 p(random.inCube()), q(random.inCube());
            const CasterBox box{std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y),
                                std::max(p.y, q.y), std::max(p.z, q.z)};
            CasterPlanes planes;
            for (HalfSpace& of : planes) {
                const glm::vec3 normal(random.inCube());
                of = {normal.x, normal.y, normal.z, 0.6f};
            }
            std::set<Pixel> expected, found;
            for (const auto& of : points)
                for (const FacePoint& point : of) {
                    const glm::vec3& at = point.at;
                    const bool inBox = at.x >= box.u0 && at.x <= box.u1 && at.y >= box.v0 &&
                                       at.y <= box.v1 && at.z <= box.highest;
                    const auto holds = [&](const HalfSpace& half) {
                        return half.a * at.x + half.b * at.y + half.c * at.z + half.d >= 0.0f;
                    };
                    if (inBox && std::all_of(planes.begin(), planes.end(), holds))
                        expected.insert(point.pixel);
                }
            // Found once, though it is queried twice.
            for (const CasterPlanes* by : {static_cast<const CasterPlanes*>(nullptr),
                                           static_cast<const CasterPlanes*>(&planes)}) {
                PointTree::Groups groups;
                tree.gather(box, by, groups);
                tree.find(
                    groups, box, [&]() -> const CasterPlanes& { return planes; },
                    [](Pixel) { return true; },
                    [&](Pixel pixel) { EXPECT_TRUE(found.insert(pixel).second); });
            }
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(CasterRuns, HoldEveryTriangleWithItsOwnCorners) {
    Random random(9);
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 90; ++i)
        positions.emplace_back(random.inCube());
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < 3 * 100; ++i)
        indices.push_back(static_cast<std::uint32_t>(random.below(90)));
    const CasterRuns casters(positions, indices);
    std::size_t triangle = 0;
    for (const CasterRuns::Run& run : casters.runs())
        for (const CasterRuns::Triangle& of : casters.trianglesOf(run)) {
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::vec3& at = casters.verticesOf(run)[of[c]];
                EXPECT_EQ(at, positions[indices[3 * triangle + c]]);
                EXPECT_TRUE(run.bounds.holds(glm::dvec3(at)));
            }
            ++triangle;
        }
    EXPECT_EQ(triangle, 100u);
    EXPECT_EQ(casters.runs().size(), 4u);
}

} // namespace
} // namespace edgeshade
