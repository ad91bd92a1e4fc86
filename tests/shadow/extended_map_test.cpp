// Primitive maps for the whole of a light with an extent, without a GL: texels must hold all
// triangles between their points and any of the light's places (docs/method.md, C42).
#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/primitive_map/footprint.hpp"
#include "src/shadow/primitive_map/primitive_map_builder.hpp"
#include "tests/support/extended_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/primitive_pairs.hpp"
#include "tests/support/scene_builder.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <tuple>

namespace edgeshade::test {
namespace {

using Corners = std::array<glm::dvec3, 3>;
using Name = std::array<float, 9>; ///< a record's name: its corners

class Draw {
  public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    glm::dvec3 inCube() { return 2.0 * glm::dvec3(unit(), unit(), unit()) - 1.0; }

  private:
    std::mt19937 random_;
};

Light panelAt(const glm::dvec3& place, const glm::dvec2& size) {
    return test::panelAt(place, size, glm::normalize(-place));
}

/// Small boxes, a wall and some loose triangles, all within 1 of the origin.
Scene clutter(unsigned seed) {
    Draw draw(seed);
    SceneBuilder builder;
    builder.quad({-1, -1, 1}, {1, -1, 1}, {1, -1, -1}, {-1, -1, -1});
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 at(0.8 * draw.inCube());
        builder.box(at - 0.15f, at + static_cast<float>(0.15 * draw.unit()));
        builder.triangle(glm::vec3(draw.inCube()), glm::vec3(draw.inCube()),
                         glm::vec3(draw.inCube()));
    }
    return builder.scene();
}

Name nameOf(std::array<glm::vec3, 3> corners) {
    std::sort(corners.begin(), corners.end(), [](const glm::vec3& a, const glm::vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    });
    Name name;
    for (std::size_t i = 0; i < 9; ++i)
        name[i] = corners[i / 3][static_cast<glm::length_t>(i % 3)];
    return name;
}

/// A map's answer for a point.
struct Answer {
    bool outside = false, dark = false;
    std::set<Name> listed;
};

Answer lookUp(const PrimitiveMap& map, const glm::dvec3& world) {
    const glm::dvec3 point(map.tiles.mapFromWorld * glm::dvec4(world, 1.0));
    for (std::size_t tile = 0; tile < map.tiles.tiles.size(); ++tile) {
        const glm::dvec3 ray = map.tiles.rayTo(tile, point);
        const glm::dvec2 at = glm::dvec2(ray) / ray.z;
        if (!(ray.z > 0.0) || std::max(std::abs(at.x), std::abs(at.y)) > 1.0) continue;
        const auto cell = [&](double along) {
            return std::min(static_cast<std::size_t>((along + 1.0) * 0.5 * map.size),
                            static_cast<std::size_t>(map.size) - 1);
        };
        const auto size = static_cast<std::size_t>(map.size);
        const glm::vec2 texel =
            test::pairAt(map.texels, (tile * size + cell(at.y)) * size + cell(at.x));
        const double depth = map.tiles.directional ? point.z : ray.z;
        Answer answer{false, depth > texel.x, {}};
        if (texel.y <= 0.0f) return answer;
        const auto entries = std::span(map.texels).subspan(map.entriesBegin());
        for (auto i = static_cast<std::size_t>(texel.y);; ++i) {
            const glm::vec2 entry = test::pairAt(entries, i);
            const glm::vec4* const record =
                &map.texels[map.recordsBegin() + 3 * static_cast<std::size_t>(entry.x)];
            answer.listed.insert(
                nameOf({glm::vec3(record[0]), glm::vec3(record[1]), glm::vec3(record[2])}));
            if (depth <= entry.y) return answer;
        }
    }
    return {true, false, {}};
}

/// How far inside the triangle the line from the point to the place passes; above 0 it meets it.
double meets(const Corners& triangle, const glm::dvec3& point, const glm::dvec4& place) {
    const glm::dvec3 way = glm::dvec3(place) - place.w * point;
    const glm::dvec3 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
    const glm::dvec3 p = glm::cross(way, ac);
    const double det = glm::dot(ab, p);
    if (std::abs(det) < 1e-7) return -1.0;
    const glm::dvec3 s = point - triangle[0], q = glm::cross(s, ab);
    const double u = glm::dot(s, p) / det, v = glm::dot(way, q) / det, t = glm::dot(ac, q) / det;
    const double end = place.w == 0.0 ? 1.0 : 1.0 - t;
    return std::min({u, v, 1.0 - u - v, t, end});
}

struct Tally {
    std::size_t dark = 0, blocked = 0, missing = 0, wronglyDark = 0, outside = 0;
};

/// Queries arbitrary points and places of the light.
Tally askAround(const Scene& scene, const Light& light, int size, std::size_t points) {
    const auto shadows = buildPlanePairs(scene, false);
    std::vector<PlacedCasters> casters;
    for (std::size_t i = 0; i < shadows.size(); ++i)
        casters.push_back({std::make_shared<const CasterEdges>(casterEdgesOf(*shadows[i])),
                           scene.batches[i].worldFromBatch});
    PrimitiveMapSettings settings;
    settings.size = size;
    settings.mostSplits = 0;
    settings.othersReceive = true;
    for (const double corner : {-1.5, 1.5})
        settings.receivers.add(glm::dvec3(corner));
    PrimitiveMapBuilder builder(light, casters, settings);
    builder.buildAllParts();
    const PrimitiveMap map = builder.join().value();
    EXPECT_TRUE(map.extended);

    std::vector<Corners> triangles;
    std::vector<Name> names;
    for (const Batch& batch : scene.batches)
        for (std::size_t i = 0; i < batch.geometry->indices.size(); i += 3) {
            Corners corners;
            std::array<glm::vec3, 3> inMap;
            for (std::size_t c = 0; c < 3; ++c) {
                corners[c] = batch.geometry->positions[batch.geometry->indices[i + c]];
                inMap[c] = glm::vec3(map.tiles.mapFromWorld * glm::dvec4(corners[c], 1.0));
            }
            triangles.push_back(corners);
            names.push_back(nameOf(inMap));
        }
    const std::vector<Light> places = lightPoints(light, 24);
    Draw draw(7);
    Tally tally;
    for (std::size_t i = 0; i < points; ++i) {
        const glm::dvec3 point = 1.5 * draw.inCube();
        const Answer answer = lookUp(map, point);
        tally.dark += answer.dark;
        tally.outside += answer.outside;
        for (const Light& place : places) {
            double most = -1.0;
            for (std::size_t t = 0; t < triangles.size(); ++t) {
                const double by = meets(triangles[t], point, place.position);
                most = std::max(most, by);
                if (by < 1e-4) continue;
                ++tally.blocked;
                tally.missing += !answer.dark && !answer.listed.contains(names[t]);
            }
            tally.wronglyDark += answer.dark && most < -1e-4;
        }
    }
    return tally;
}

TEST(ExtendedMap, HoldsAllThatIsBetweenItsPointsAndTheLight) {
    const std::vector<Light> lights = {
        sphereAt({0.5, 5, 1}, 0.4),       // one tile
        sphereAt({0.1, 0.2, -0.1}, 0.1),  // among the casters
        sphereAt({0.2, -0.98, 0.3}, 0.2), // half below the floor
        panelAt({3, 3, 1}, {1, 0.5}),     panelAt({0, 0.9, 0}, {0.8, 0.4}),
        discTowards({0.3, 1, 0.2}, 0.53), discTowards({1, 0.2, -0.4}, 8.0)};
    for (std::size_t l = 0; l < lights.size(); ++l)
        for (const int size : {8, 64}) {
            const Tally tally = askAround(clutter(static_cast<unsigned>(l)), lights[l], size, 1500);
            EXPECT_GT(tally.blocked, 500u) << l;
            EXPECT_EQ(tally.missing, 0u) << l << ", size " << size;
            EXPECT_EQ(tally.wronglyDark, 0u) << l << ", size " << size;
        }
}

TEST(ExtendedMap, KnowsWhatNothingOfTheLightReaches) {
    // Only a large wall: behind its middle everything is dark without any test.
    const Scene scene = SceneBuilder().quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}).scene();
    for (const Light& light : {sphereAt({0, 3, 0}, 0.2), discTowards({0.1, 1, 0}, 2.0)}) {
        const Tally tally = askAround(scene, light, 64, 2000);
        EXPECT_GT(tally.dark, 200u);
        EXPECT_EQ(tally.wronglyDark, 0u);
        EXPECT_EQ(tally.missing, 0u);
    }
}

/// Length of the longest list, for this many sheets above each other, that is known before any part
/// of their map is built.
std::size_t longListBeforeBuilding(int sheets, std::size_t longestWanted) {
    SceneBuilder builder;
    for (int i = 0; i < sheets; ++i) {
        const float y = 0.5f + 0.01f * static_cast<float>(i);
        builder.quad({-0.5f, y, 0.5f}, {0.5f, y, 0.5f}, {0.5f, y, -0.5f}, {-0.5f, y, -0.5f});
    }
    const Scene scene = builder.scene();
    const auto shadows = buildPlanePairs(scene, false);
    const Light light = discTowards({0.4, 1, 0.3}, 3.0);
    PrimitiveMapSettings settings;
    settings.size = 64;
    settings.mostSplits = 0;
    settings.longestWanted = longestWanted;
    for (const double corner : {-2.0, 2.0})
        settings.receivers.add(glm::dvec3(corner));
    const std::vector<PlacedCasters> casters = {
        {std::make_shared<const CasterEdges>(casterEdgesOf(*shadows[0]))}};
    PrimitiveMapBuilder ahead(light, casters, settings);
    ahead.lookForLongLists();
    const std::size_t known = ahead.tooLong();
    ahead.buildAllParts();
    EXPECT_EQ(ahead.join().has_value(), known == 0);
    return known;
}

TEST(ExtendedMap, WithTooLongAListIsGivenUpBeforeItIsBuilt) {
    EXPECT_GT(longListBeforeBuilding(60, 50), 50u);
    EXPECT_EQ(longListBeforeBuilding(60, 1000), 0u);
}

TEST(LightShape, ReachesAsFarAsItsPoints) {
    for (const Light& light : {sphereAt({0.5, 2, 1}, 0.4), panelAt({3, 3, 1}, {1, 0.5}),
                               discTowards({0.3, 1, 0.2}, 40.0)}) {
        const LightShape shape = shapeOf(light);
        Draw draw(1);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 normal = draw.inCube();
            double most = 0.0;
            for (const Light& place : lightPoints(light, 500)) {
                glm::dvec3 at(place.position);
                if (shape.center.w == 0.0) at /= glm::dot(at, glm::dvec3(shape.center));
                const double far = std::abs(glm::dot(normal, at - glm::dvec3(shape.center)));
                EXPECT_LE(far, shape.support(normal) * (1.0 + 1e-9) + 1e-12);
                most = std::max(most, far);
            }
            EXPECT_GT(most, 0.7 * shape.support(normal));
        }
    }
}

TEST(LightShape, IsOnASideOnlyWithAllOfIt) {
    const Corners facing = {glm::dvec3(0, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)};
    EXPECT_EQ(sideOfAll(facing, shapeOf(sphereAt({0, 1, 0}, 0.9))), 1);
    EXPECT_EQ(sideOfAll(facing, shapeOf(sphereAt({0, 1, 0}, 1.1))), 0);
    EXPECT_EQ(sideOfAll(facing, shapeOf(sphereAt({0, -1, 0}, 0.9))), -1);
    EXPECT_EQ(sideOfAll(facing, shapeOf(discTowards({1, 0.1, 0}, 4.0))), 1);
    EXPECT_EQ(sideOfAll(facing, shapeOf(discTowards({1, 0.1, 0}, 14.0))), 0);
}

} // namespace
} // namespace edgeshade::test
