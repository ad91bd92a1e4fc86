// RayCrossings between a near rectangle and a light: where they are reported as even, every point
// of the rectangle must be inside the same number of volumes, by plain counting.
#include "src/shadow/plan/ray_crossings.hpp"

#include "src/shadow/silhouette/light_facings.hpp"
#include "tests/support/small_soups.hpp"
#include "tests/support/soup_shadow.hpp"

#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade {
namespace {

using test::Random;
using test::shadowOf;
using test::Soup;

/// All triangles between start and light, by barycentric coordinates.
int trianglesOnTheWay(const PlanePairShadow& shadow, const ShadowCluster& cluster,
                      const glm::dvec3& start, const glm::dvec4& light) {
    const glm::dvec3 way = glm::dvec3(light) - start * light.w;
    int count = 0;
    for (std::uint32_t i = cluster.caps.first; i < cluster.caps.end(); ++i) {
        const CapRecord& cap = shadow.caps[i];
        const glm::dvec3 a(cap.a), ab = glm::dvec3(cap.b) - a, ac = glm::dvec3(cap.c) - a;
        const glm::dvec3 p = glm::cross(way, ac);
        const double determinant = glm::dot(ab, p);
        if (determinant == 0.0) continue;
        const glm::dvec3 q = glm::cross(start - a, ab);
        const double u = glm::dot(start - a, p) / determinant;
        const double v = glm::dot(way, q) / determinant;
        const double t = glm::dot(ac, q) / determinant;
        count += u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && (light.w == 0.0 || t < 1.0);
    }
    return count;
}

/// A few overlapping triangles of about one unit, some sharing edges.
Soup anySoup(Random& random) {
    Soup soup;
    for (int i = 0; i < 8; ++i)
        soup.positions.emplace_back(2.0 * random.inCube());
    const int triangles = 3 + random.below(12);
    for (int i = 0; i < 3 * triangles; ++i)
        soup.indices.push_back(static_cast<std::uint32_t>(random.below(8)));
    return soup;
}

/// The caps that may meet a volume.
Touched touching(const NearClipVolume& volume, const ShadowCluster& cluster,
                 const PlanePairShadow& shadow, std::size_t limit = mostTouched) {
    Touched touched;
    findTouching(ClipVolumeFaces(volume), cluster, shadow, touched, limit);
    return touched;
}

} // namespace

TEST(RayCrossings, WhereTheyAreEvenEveryPointHasAsMany) {
    Random random(5);
    std::size_t even = 0, within = 0, uneven = 0;
    for (int i = 0; i < 60'000; ++i) {
        const PlanePairShadow shadow = shadowOf(anySoup(random));
        const glm::dvec3 corner = 3.0 * random.inCube();
        const glm::dvec3 right = random.inCube() * random.magnitude(-4, -0.5);
        const glm::dvec3 up = random.inCube() * random.magnitude(-4, -0.5);
        const bool directional = random.below(3) == 0;
        const glm::dvec4 light(glm::dvec3(glm::vec3(3.0 * random.inCube())), !directional);
        const NearClipVolume pyramid{{{corner, corner + right, corner + right + up, corner + up}},
                                     light};
        for (const ShadowCluster& cluster : shadow.clusters) {
            Touched touched = touching(pyramid, cluster, shadow);
            if (touched.caps.empty()) continue;
            if (evennessOf(ClipVolumeFaces(pyramid), touched, shadow, dotRounding(23)) !=
                Evenness::even) {
                ++uneven;
                continue;
            }
            const auto crossings =
                crossingsFromSomePoint(pyramid, touched.caps, shadow, dotRounding(23));
            if (!crossings) continue;
            ++even;
            within += crossings->all() > 0;
            for (int k = 0; k < 4; ++k) {
                const double s = random.uniform(0, 1), t = random.uniform(0, 1);
                const glm::dvec3 start = corner + s * right + t * up;
                ASSERT_EQ(crossings->all(), trianglesOnTheWay(shadow, cluster, start, light));
                ASSERT_EQ(crossings->all(), crossings->outwards + crossings->inwards);
            }
        }
    }
    std::cout << even << " even, " << within << " of them within a volume; " << uneven
              << " uneven\n";
    EXPECT_GT(within, 3'000u);
    EXPECT_GT(uneven, 3'000u);
}

TEST(RayCrossings, OfASilhouetteAreUneven) {
    // One triangle whose edge is over the middle of the rectangle.
    const PlanePairShadow shadow = shadowOf({{{0, 1, -5}, {0, 1, 5}, {5, 1, 0}}, {0, 1, 2}});
    const NearClipVolume pyramid{{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}}, {0, 9, 0, 1}};
    Touched touched = touching(pyramid, shadow.clusters[0], shadow);
    EXPECT_EQ(evennessOf(ClipVolumeFaces(pyramid), touched, shadow, dotRounding(23)),
              Evenness::outlineMet);
}

TEST(RayCrossings, OfATriangleThroughTheRectangleAreUneven) {
    const PlanePairShadow shadow = shadowOf({{{-9, -1, -9}, {9, -1, -9}, {0, 2, 9}}, {0, 1, 2}});
    const NearClipVolume pyramid{{{{-1, 0, -4}, {1, 0, -4}, {1, 0, 1}, {-1, 0, 1}}}, {0, 9, 0, 1}};
    Touched touched = touching(pyramid, shadow.clusters[0], shadow);
    EXPECT_EQ(evennessOf(ClipVolumeFaces(pyramid), touched, shadow, dotRounding(23)),
              Evenness::rectangleMet);
}

TEST(RayCrossings, OfALightInATrianglesPlaneAreUncertain) {
    const PlanePairShadow shadow = shadowOf({{{-9, 1, -9}, {9, 1, -9}, {0, 1, 9}}, {0, 1, 2}});
    const NearClipVolume pyramid{{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}}, {0, 1, 0, 1}};
    Touched touched = touching(pyramid, shadow.clusters[0], shadow);
    EXPECT_EQ(evennessOf(ClipVolumeFaces(pyramid), touched, shadow, dotRounding(23)),
              Evenness::uncertain);
    EXPECT_FALSE(crossingsFromSomePoint(pyramid, touched.caps, shadow, dotRounding(23)));
}

TEST(RayCrossings, TooManyTrianglesAreNotCounted) {
    Soup stack;
    for (int i = 0; i < 2000; ++i) {
        const float y = 1.0f + 0.001f * static_cast<float>(i);
        stack.positions.insert(stack.positions.end(), {{-9, y, -9}, {9, y, -9}, {0, y, 9}});
        const auto first = static_cast<std::uint32_t>(3 * i);
        stack.indices.insert(stack.indices.end(), {first, first + 1, first + 2});
    }
    const PlanePairShadow shadow = shadowOf(stack);
    const NearClipVolume pyramid{{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}}, {0, 9, 0, 1}};
    std::size_t touched = 0;
    bool tooMany = false;
    for (const ShadowCluster& cluster : shadow.clusters) {
        const Touched of = touching(pyramid, cluster, shadow, 100);
        touched += of.caps.size();
        tooMany = tooMany || of.tooMany;
    }
    EXPECT_TRUE(tooMany);
    EXPECT_LT(touched, 2000u);
}

} // namespace edgeshade
