// Rays by Embree, doubles and integers, compared with every triangle in rational numbers.
#include "tests/rays/rational_rays.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using rays::SurfacePoint;
using rays::SurfaceTriangle;
using test::Random;

struct Soup {
    Scene scene;
    std::vector<SurfaceTriangle> triangles;
};

/// A scene as triangles relative to `origin`.
Soup soupOf(const test::SceneBuilder& builder, const glm::dvec3& origin) {
    Soup soup{builder.scene(), {}};
    soup.triangles = rays::surfaceTriangles(soup.scene, origin, false, false);
    return soup;
}

glm::dvec3 cornerOf(const SurfaceTriangle& triangle, int i) {
    return i == 0 ? triangle.a : i == 1 ? triangle.b : triangle.c;
}

/// A place on a triangle: a corner, on an edge, or anywhere within.
glm::dvec3 placeOn(Random& random, const SurfaceTriangle& triangle) {
    double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
    switch (random.below(4)) {
    case 0:
        u = random.below(2), v = 0.0;
        break;
    case 1:
        v = 0.0;
        u = random.below(5) / 4.0;
        break;
    default:
        break;
    }
    return triangle.a + u * (triangle.b - triangle.a) + v * (triangle.c - triangle.a);
}

SurfacePoint pointOn(Random& random, const std::vector<SurfaceTriangle>& triangles) {
    const auto i = static_cast<std::uint32_t>(random.below(static_cast<int>(triangles.size())));
    const glm::dvec3 place = placeOn(random, triangles[i]);
    const glm::dvec3 normal = normalOf(triangles[i]);
    const double side = random.below(2) ? 1.0 : -1.0;
    switch (random.below(6)) {
    case 0: // a line of sight
        return {place + side * glm::length(triangles[i].b - triangles[i].a) * random.inCube(),
                random.inCube(), i};
    case 1: // one that begins elsewhere and goes through the place
    {
        const glm::dvec3 eye =
            place + glm::length(triangles[i].b - triangles[i].a) * random.inCube();
        return {eye, place - eye, i};
    }
    case 2: // in free space, facing one way or none
        return SurfacePoint::at(place, random.below(2) ? normal : glm::dvec3(0.0),
                                SurfacePoint::none);
    default:
        return SurfacePoint::at(place, side * normal, i);
    }
}

/// A direction: anywhere, through a corner or an edge of a triangle, in its plane, along its edge.
glm::dvec3 directionFrom(Random& random, const glm::dvec3& place,
                         const std::vector<SurfaceTriangle>& triangles) {
    const SurfaceTriangle& of =
        triangles[static_cast<std::size_t>(random.below(static_cast<int>(triangles.size())))];
    glm::dvec3 direction = random.inCube();
    switch (random.below(6)) {
    case 0:
        direction = cornerOf(of, random.below(3)) - place;
        break;
    case 1:
        direction = glm::mix(of.a, of.b, random.below(5) / 4.0) - place;
        break;
    case 2:
        direction = random.uniform(-1, 1) * (of.b - of.a) + random.uniform(-1, 1) * (of.c - of.a);
        break;
    case 3:
        direction = of.c - of.b;
        break;
    case 4:
        direction = round(2.0 * direction);
        break;
    default:
        break;
    }
    return direction == glm::dvec3(0.0) ? glm::dvec3(0.0, 1.0, 0.0) : direction;
}

/// Compares all pairs of points and directions with rational numbers; returns the lit share.
double compareAll(Random& random, const Soup& soup, int pointCount, int directionCount) {
    const rays::LitRays litRays(soup.scene, soup.triangles);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < pointCount; ++i)
        points.push_back(pointOn(random, soup.triangles));
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < directionCount; ++i) {
        const SurfacePoint& from = points[static_cast<std::size_t>(random.below(pointCount))];
        directions.push_back(
            directionFrom(random, test::placeRationally(soup.triangles, from), soup.triangles));
    }
    const rays::LitBits bits = litRays.lit(points, directions);
    std::size_t lit = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        for (std::size_t d = 0; d < directions.size(); ++d) {
            const bool expected =
                test::isLitRationally(soup.scene, soup.triangles, points[p], directions[d]);
            EXPECT_EQ(bits.at(p, d), expected)
                << "point " << p << " on " << points[p].triangle << ", direction " << d;
            lit += expected;
        }
    return static_cast<double>(lit) / static_cast<double>(points.size() * directions.size());
}

/// Triangles over a lattice of 4 x 4 x 4: they share corners and edges, coincide and are coplanar.
test::SceneBuilder latticeSoup(Random& random, int triangles) {
    test::SceneBuilder builder;
    const auto corner = [&] {
        const double x = random.below(4), y = random.below(4), z = random.below(4);
        return glm::vec3(x, y, z);
    };
    for (int i = 0; i < triangles; ++i) {
        const glm::vec3 a = corner(), b = corner(), c = corner();
        builder.triangle(a, b, c);
    }
    return builder;
}

/// Triangles of any shape around a place: slivers, needles and corners on edges.
test::SceneBuilder crookedSoup(Random& random, int triangles) {
    test::SceneBuilder builder;
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 6; ++i)
        corners.push_back(random.inCube());
    const auto any = [&] {
        return corners[static_cast<std::size_t>(random.below(static_cast<int>(corners.size())))];
    };
    for (int i = 0; i < triangles; ++i) {
        glm::dvec3 a = any(), b = any(), c = random.inCube();
        if (random.below(3) == 0) c = glm::mix(a, b, random.uniform(-1, 2)); // rounded to floats
        if (random.below(4) == 0) b = a + b * random.magnitude(-7, -3);
        builder.triangle(glm::vec3(a), glm::vec3(b), glm::vec3(c));
        corners.push_back(glm::dvec3(glm::vec3(c)));
    }
    return builder;
}

glm::dmat4 placing(Random& random, double scale, const glm::dvec3& away) {
    const glm::dmat4 turned =
        glm::rotate(glm::dmat4(1.0), random.uniform(0, 6), glm::normalize(random.inCube()));
    return glm::translate(glm::dmat4(1.0), away) * glm::scale(turned, glm::dvec3(scale));
}

TEST(CertifiedRays, OfLatticeSoupsAreExact) {
    Random random(1);
    double lit = 0.0;
    for (int i = 0; i < 30; ++i) {
        const Soup soup = soupOf(latticeSoup(random, 5 + random.below(30)), glm::dvec3(0.0));
        lit += compareAll(random, soup, 20, 20) / 30.0;
    }
    EXPECT_GT(lit, 0.05);
    EXPECT_LT(lit, 0.95);
}

TEST(CertifiedRays, OfSliversAndNeedlesAreExact) {
    Random random(2);
    double lit = 0.0;
    for (int i = 0; i < 30; ++i)
        lit += compareAll(random, soupOf(crookedSoup(random, 30), glm::dvec3(0.0)), 20, 20) / 30.0;
    EXPECT_GT(lit, 0.05);
    EXPECT_LT(lit, 0.95);
}

// A transform to the world and to the origin rounds corners; what is rounded is then exact.
TEST(CertifiedRays, AreExactAtAnyScaleAndFarAway) {
    Random random(3);
    for (const double scale : {1e-12, 1e-3, 1.0, 1e6, 1e18})
        for (const double away : {0.0, 1e6})
            for (int i = 0; i < 5; ++i) {
                const glm::dvec3 offset = scale * away * glm::dvec3(1.0, -0.5, 0.7);
                test::SceneBuilder builder =
                    i % 2 ? latticeSoup(random, 20) : crookedSoup(random, 20);
                builder.placedBy(placing(random, scale, offset));
                for (const glm::dvec3& origin : {glm::dvec3(0.0), offset})
                    compareAll(random, soupOf(builder, origin), 16, 12);
            }
}

// Packets whose points are far apart, and points far outside of all triangles.
TEST(CertifiedRays, OfPointsFarOutsideAreExact) {
    Random random(4);
    const Soup soup = soupOf(latticeSoup(random, 20), glm::dvec3(0.0));
    const rays::LitRays litRays(soup.scene, soup.triangles);
    std::size_t lit = 0, all = 0;
    for (const double distance : {2.0, 10.0, 1e3, 1e7, 1e12}) {
        std::vector<SurfacePoint> points;
        std::vector<glm::dvec3> directions;
        for (int i = 0; i < 12; ++i) {
            const glm::dvec3 away = distance * random.inCube();
            points.push_back(SurfacePoint::at(away, glm::dvec3(0.0), SurfacePoint::none));
            directions.push_back(placeOn(random, soup.triangles[static_cast<std::size_t>(i)]) -
                                 away);
        }
        const rays::LitBits bits = litRays.lit(points, directions);
        for (std::size_t p = 0; p < points.size(); ++p)
            for (std::size_t d = 0; d < directions.size(); ++d) {
                const bool expected =
                    test::isLitRationally(soup.scene, soup.triangles, points[p], directions[d]);
                ASSERT_EQ(bits.at(p, d), expected) << distance;
                lit += expected;
                ++all;
            }
    }
    EXPECT_GT(lit, all / 20);
    EXPECT_LT(lit, all);
}

} // namespace
} // namespace edgeshade
