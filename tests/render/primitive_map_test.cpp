// Primitive maps without a GL: the answers of their tables for points, by the shader's own source,
// against exact rays (docs/method.md, C34 and C35).
#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/scene/gpu_primitive_map.hpp"
#include "src/shadow/lights/light_extent.hpp"
#include "src/shadow/primitive_map/footprint.hpp"
#include "src/shadow/primitive_map/primitive_map_builder.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/primitive_lookup.hpp"
#include "tests/support/primitive_pairs.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>
#include <random>

namespace edgeshade::test {
namespace {

using Corners = std::array<glm::dvec3, 3>;

class Draw {
  public:
    explicit Draw(unsigned seed) : random_(seed) {}
    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
    glm::dvec3 inCube() { return 2.0 * glm::dvec3(unit(), unit(), unit()) - 1.0; }
    std::size_t below(std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
    }

  private:
    std::mt19937 random_;
};

glm::dvec3 pointOn(const Corners& triangle, Draw& draw) {
    double u = draw.unit(), v = draw.unit();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
}

std::vector<Corners> trianglesOf(const Scene& scene) {
    std::vector<Corners> triangles;
    for (const Batch& batch : scene.batches)
        for (std::size_t i = 0; i < batch.geometry->indices.size(); i += 3) {
            Corners corners;
            for (std::size_t c = 0; c < 3; ++c)
                corners[c] = glm::dvec3(
                    batch.worldFromBatch *
                    glm::dvec4(
                        glm::dvec3(batch.geometry->positions[batch.geometry->indices[i + c]]),
                        1.0));
            triangles.push_back(corners);
        }
    return triangles;
}

/// `lookingUp`: the surfaces that look up; null: any may.
PrimitiveMap mapOf(const Scene& scene, const Light& light, int size, bool othersReceive,
                   const std::vector<WorldTriangle>* lookingUp = nullptr) {
    std::vector<PlacedCasters> casters;
    const auto shadows = buildPlanePairs(scene, false);
    for (std::size_t i = 0; i < shadows.size(); ++i)
        casters.push_back({std::make_shared<const CasterEdges>(casterEdgesOf(*shadows[i])),
                           scene.batches[i].worldFromBatch});
    PrimitiveMapSettings settings;
    settings.size = size;
    settings.othersReceive = othersReceive;
    settings.lookingUp = lookingUp;
    PrimitiveMapBuilder builder(light, casters, settings);
    builder.buildAllParts();
    return builder.join().value();
}

/// Whether a triangle is certainly between the point and the light, certainly not, or neither: too
/// close to an edge or to an end.
std::optional<bool> isBetween(const Corners& triangle, const glm::dvec3& point,
                              const Light& light) {
    constexpr double near = 1e-4, nearPlane = 2e-4; // for scenes of about 8
    const glm::dvec3 way = glm::dvec3(light.position) - light.position.w * point;
    const glm::dvec3 ab = triangle[1] - triangle[0], ac = triangle[2] - triangle[0];
    const glm::dvec3 p = glm::cross(way, ac);
    const double det = glm::dot(ab, p);
    const double scale = glm::length(way) * glm::length(ab) * glm::length(ac);
    const glm::dvec3 s = point - triangle[0];
    const double height = glm::dot(glm::normalize(glm::cross(ab, ac)), s);
    const bool touches = std::abs(height) < nearPlane;
    if (!(std::abs(det) > 1e-6 * scale)) // parallel
        return touches ? std::nullopt : std::optional(false);
    const glm::dvec3 q = glm::cross(s, ab);
    const double u = glm::dot(s, p) / det, v = glm::dot(way, q) / det;
    const double t = glm::dot(ac, q) / det * glm::length(way); // a length
    const double inside = std::min({u, v, 1.0 - u - v});
    const double end = light.position.w == 0.0 ? INFINITY : glm::length(way);
    if (inside < -near || t < -near || t > end + near) return false;
    if (inside > near && t > near && t < end - near && !touches) return true;
    return std::nullopt;
}

/// Whether the light reaches the point past all triangles except the one that it lies on.
std::optional<bool> isLit(const std::vector<Corners>& triangles, std::size_t own,
                          const glm::dvec3& point, const Light& light) {
    bool certain = true;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i == own) continue;
        const auto between = isBetween(triangles[i], point, light);
        if (between && *between) return false;
        certain = certain && between;
    }
    return certain ? std::optional(true) : std::nullopt;
}

struct Tally {
    std::size_t lit = 0, dark = 0, wrong = 0;
};

/// Queries the map for points on the scene's triangles and, with `anywhere`, between them.
Tally askAround(const Scene& scene, const Light& light, int size, bool anywhere, std::size_t points,
                unsigned seed) {
    const PrimitiveMap map = mapOf(scene, light, size, anywhere);
    const PrimitiveLookup lookup(map);
    const std::vector<Corners> triangles = trianglesOf(scene);
    Draw draw(seed);
    Tally tally;
    const Box bounds = worldBounds(scene);
    const bool mirrored = glm::determinant(glm::dmat3(scene.batches.front().worldFromBatch)) < 0.0;
    for (std::size_t i = 0; i < points; ++i) {
        std::size_t own = triangles.size();
        glm::dvec3 point = bounds.center() + 0.6 * draw.inCube() * (bounds.high - bounds.low);
        bool casts = false;
        if (!anywhere || i % 2 == 0) {
            own = draw.below(triangles.size());
            const Corners& on = triangles[own];
            point = pointOn(on, draw);
            casts = (lightSideOf(on, light.position) > 0) != mirrored;
        }
        const auto expected = isLit(triangles, own, point, light);
        if (!expected) continue;
        ++(*expected ? tally.lit : tally.dark);
        if (lookup.lights(point, casts) == *expected) continue;
        ++tally.wrong;
    }
    return tally;
}

/// Boxes, thin plates and loose triangles that penetrate each other.
Scene clutter(unsigned seed, int pieces) {
    Draw draw(seed);
    SceneBuilder builder;
    builder.floor(4.0f, -1.5f);
    for (int i = 0; i < pieces; ++i) {
        const glm::vec3 at(2.0 * draw.inCube());
        const glm::vec3 size(0.02 + 0.6 * glm::dvec3(draw.unit(), draw.unit(), draw.unit()));
        switch (i % 4) {
        case 0:
            builder.box(at, at + size);
            break;
        case 1: // a plate
            builder.box(at, at + size * glm::vec3(1.0f, 0.004f, 1.0f));
            break;
        case 2: // turned inside out
            builder.box(at + size, at);
            break;
        default:
            builder.triangle(at, at + glm::vec3(draw.inCube()), at + glm::vec3(draw.inCube()));
            break;
        }
    }
    return builder.scene();
}

const std::vector<Light>& lights() {
    static const std::vector<Light> all = {
        sun({0.3, 1, 0.2}),        sun({1, 0.05, 0.3}),    sun({0, 1, 0}),
        pointLight({0.2, 6, 0.4}), pointLight({9, 1, -3}), pointLight({0.1, 0.2, 0.3}),
        pointLight({-1.2, 2, 0.9})};
    return all;
}

class PrimitiveMaps : public testing::TestWithParam<std::size_t> {};

TEST_P(PrimitiveMaps, SayOfPointsOnCastersWhatRaysSay) {
    const Light& light = lights()[GetParam()];
    Tally all;
    for (unsigned seed = 1; seed <= 6; ++seed)
        for (const int size : {4, 64}) {
            const Tally tally = askAround(clutter(seed, 40), light, size, false, 4000, seed);
            EXPECT_EQ(tally.wrong, 0u) << "seed " << seed << ", size " << size;
            all.lit += tally.lit;
            all.dark += tally.dark;
        }
    EXPECT_GT(all.lit, 2000u);
    EXPECT_GT(all.dark, 2000u);
}

TEST_P(PrimitiveMaps, SayOfPointsAnywhereWhatRaysSay) {
    const Light& light = lights()[GetParam()];
    for (unsigned seed = 11; seed <= 14; ++seed) {
        const Tally tally = askAround(clutter(seed, 40), light, 64, true, 4000, seed);
        EXPECT_EQ(tally.wrong, 0u) << "seed " << seed;
        EXPECT_GT(tally.dark, 200u);
    }
}

TEST_P(PrimitiveMaps, OfPlacedAndMirroredCasters) {
    const Light& light = lights()[GetParam()];
    Scene scene = clutter(5, 30);
    glm::dmat4 place(1.0);
    place[0] = {-1.0, 0.2, 0.0, 0.0}; // mirrored and sheared
    place[1] = {0.1, 1.3, 0.2, 0.0};
    place[3] = {0.5, 0.1, -0.3, 1.0};
    scene.batches.front().worldFromBatch = place;
    EXPECT_EQ(askAround(scene, light, 64, false, 8000, 7).wrong, 0u);
}

INSTANTIATE_TEST_SUITE_P(Lights, PrimitiveMaps, testing::Range<std::size_t>(0, 7));

class TenMillionPoints : public testing::TestWithParam<std::size_t> {};

TEST_P(TenMillionPoints, AreWhatRaysSay) {
    const Light& light = lights()[GetParam()];
    constexpr std::size_t points = 100'000, least = 10'000'000;
    std::size_t asked = 0;
    for (unsigned seed = 100; asked < least / lights().size() + 1; ++seed) {
        const bool anywhere = seed % 2 == 0;
        const int size = seed % 3 == 0 ? 8 : 128;
        const Scene scene = clutter(seed, 20 + static_cast<int>(seed % 5) * 10);
        const Tally tally = askAround(scene, light, size, anywhere, points, seed);
        ASSERT_EQ(tally.wrong, 0u) << "seed " << seed;
        asked += tally.lit + tally.dark;
    }
}

INSTANTIATE_TEST_SUITE_P(Long, TenMillionPoints, testing::Range<std::size_t>(0, 7));

/// dot(edge, ray) in the orders that a shader's compiler may choose.
std::array<float, 3> arrangements(const glm::vec3& edge, const glm::vec3& ray) {
    return {edge.x * ray.x + edge.y * ray.y + edge.z * ray.z,
            std::fma(edge.x, ray.x, std::fma(edge.y, ray.y, edge.z * ray.z)),
            std::fma(edge.z, ray.z, std::fma(edge.y, ray.y, edge.x * ray.x))};
}

TEST(PrimitiveMapEdges, NeighboursLeaveNoCrackInAnyArithmetic) {
    Draw draw(3);
    std::size_t onEdge = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 a(draw.inCube()), b(draw.inCube()), c(draw.inCube()), d(draw.inCube());
        const Scene scene = SceneBuilder().triangle(a, b, c).triangle(b, a, d).scene();
        const Light& light = lights()[draw.below(lights().size())];
        std::vector<PlacedCasters> casters = {
            {std::make_shared<const CasterEdges>(casterEdgesOf(*buildPlanePairs(scene, false)[0])),
             glm::dmat4(1.0)}};
        const LightTiles tiles = tilesFor(light, casters).value();
        const auto occluders = occludersOf(light, tiles, casters).all;
        if (occluders.size() != 2 || occluders[0].lightFacing != occluders[1].lightFacing) continue;
        // The edge that the two triangles share.
        for (std::size_t e = 0; e < 3; ++e)
            for (std::size_t f = 0; f < 3; ++f) {
                if (occluders[0].edges[e] != -occluders[1].edges[f]) continue;
                const glm::dvec3 at = glm::mix(occluders[0].corners[e],
                                               occluders[0].corners[(e + 1) % 3], draw.unit());
                const glm::vec3 ray(tiles.directional ? glm::dvec3(at.x, at.y, 1.0) : at);
                const auto one = arrangements(glm::vec3(occluders[0].edges[e]), ray);
                const auto other = arrangements(glm::vec3(occluders[1].edges[f]), ray);
                for (std::size_t k = 0; k < one.size(); ++k)
                    EXPECT_TRUE(one[k] >= 0.0f || other[k] >= 0.0f);
                ++onEdge;
            }
    }
    EXPECT_GT(onEdge, 500u);
}

TEST(PrimitiveMapBuilding, GivesTheSameTablesWhoeverBuildsThem) {
    const Scene scene = clutter(2, 60);
    const auto shadows = buildPlanePairs(scene, false);
    const std::vector<PlacedCasters> casters = {
        {std::make_shared<const CasterEdges>(casterEdgesOf(*shadows[0])), glm::dmat4(1.0)}};
    PrimitiveMapSettings settings;
    settings.size = 128;
    const auto build = [&](bool alone) {
        PrimitiveMapBuilder builder(lights()[3], casters, settings);
        if (alone)
            for (std::size_t part = builder.partCount(); part-- > 0;)
                builder.buildPart(part);
        else
            builder.buildAllParts();
        return builder.join().value();
    };
    const PrimitiveMap one = build(true), other = build(false);
    EXPECT_TRUE(one.headers == other.headers && one.entries == other.entries &&
                one.texels == other.texels);
}

TEST(PrimitiveMapBuilding, ListsAreDividedWhereTheyAreLong) {
    const PrimitiveMap map = mapOf(clutter(4, 200), lights()[0], 16, false);
    EXPECT_GT(map.headers, 16u * 16u);
}

/// Number of pieces of texels that are divided in turn.
std::size_t dividedPieces(const PrimitiveMap& map) {
    std::size_t divided = 0;
    const auto size = static_cast<std::size_t>(map.size);
    const std::size_t texels = map.tiles.tiles.size() * size * size;
    for (std::size_t i = texels; i < map.headers; ++i)
        divided += test::pairAt(map.texels, i).y < 0.0f ? 1 : 0;
    return divided;
}

/// Small triangles in a heap over a floor that is sixteen times as wide.
Scene heap(int triangles) {
    Draw draw(7);
    SceneBuilder builder;
    builder.floor(4.0f, -1.5f);
    for (int i = 0; i < triangles; ++i) {
        const glm::vec3 at(0.25 * draw.inCube());
        builder.triangle(at, at + glm::vec3(0.2 * draw.inCube()),
                         at + glm::vec3(0.2 * draw.inCube()));
    }
    return builder.scene();
}

TEST(PrimitiveMapBuilding, PiecesAreDividedFromLongerListsOn) {
    const Scene few = heap(16), many = heap(90);
    ASSERT_LE(few.triangleCount(), 18u);
    const PrimitiveMap ofFew = mapOf(few, lights()[0], 4, false);
    EXPECT_GT(ofFew.headers, 4u * 4u);
    EXPECT_EQ(dividedPieces(ofFew), 0u);
    EXPECT_GT(dividedPieces(mapOf(many, lights()[0], 4, false)), 0u);
}

// A worker's memory is zeroed page by page, and never shrinks: arrays that grow by doubling would
// take up to three times as much. How many records there will be is not known ahead.
TEST(PrimitiveMapBuilding, TakesNoMoreMemoryThanItsArrays) {
    const Scene scene = clutter(4, 200);
    const PrimitiveMap map = mapOf(scene, lights()[0], 16, false);
    EXPECT_GT(map.entries, 1000u);
    EXPECT_EQ(map.texels.size(), map.recordsBegin() + map.records());
    EXPECT_LE(map.texels.capacity(), map.recordsBegin() + 3 * scene.triangleCount() + 1);
}

TEST(PrimitiveMapBuilding, GivesUpWhatIsTooLarge) {
    const auto shadows = buildPlanePairs(clutter(4, 200), false);
    const std::vector<PlacedCasters> casters = {
        {std::make_shared<const CasterEdges>(casterEdgesOf(*shadows[0])), glm::dmat4(1.0)}};
    PrimitiveMapSettings settings;
    settings.mostBytes = 1000;
    PrimitiveMapBuilder builder(lights()[0], casters, settings);
    builder.buildAllParts();
    EXPECT_FALSE(builder.join());
}

TEST(PrimitiveMapBuilding, LeavesFarLightsToVolumes) {
    const auto shadows = buildPlanePairs(SceneBuilder().floor(2).scene(), false);
    const std::vector<PlacedCasters> casters = {
        {std::make_shared<const CasterEdges>(casterEdgesOf(*shadows[0])), glm::dmat4(1.0)}};
    EXPECT_TRUE(PrimitiveMapBuilder(pointLight({1e4, 1e4, 0}), casters, {}).isTooFar());
    EXPECT_FALSE(PrimitiveMapBuilder(pointLight({4, 5, 0}), casters, {}).isTooFar());
    EXPECT_FALSE(PrimitiveMapBuilder(sun({1, 1, 0}), casters, {}).isTooFar());
}

TEST(PrimitiveMapBuilding, OfNothingLightsEverything) {
    PrimitiveMapBuilder builder(lights()[0], {}, {});
    builder.buildAllParts();
    const PrimitiveMap map = builder.join().value();
    EXPECT_TRUE(PrimitiveLookup(map).lights({1, 2, 3}, false));
}

/// Small panes in and beside a box; `through`: one that goes through this point.
std::vector<WorldTriangle> panesAround(const Box& box, std::optional<glm::dvec3> through,
                                       Draw& draw) {
    std::vector<WorldTriangle> panes;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 at = box.center() + 0.5 * draw.inCube() * (box.high - box.low);
        panes.push_back({at, at + 0.7 * draw.inCube(), at + 0.7 * draw.inCube()});
    }
    const glm::dvec3 aside = draw.inCube();
    if (through) panes.push_back({*through - aside, *through + aside, *through + draw.inCube()});
    return panes;
}

/// Answers of a map for panes, for points on them. `listed`: its entries, of those of a whole map.
struct PaneTally {
    std::size_t dark = 0, wrong = 0;
    double listed = 0.0;
};

PaneTally askPanes(const Light& light, unsigned seed, bool throughLight) {
    Draw draw(seed);
    const Scene scene = clutter(seed, 300);
    const auto through = throughLight ? std::optional(glm::dvec3(light.position)) : std::nullopt;
    const std::vector<WorldTriangle> panes = panesAround(worldBounds(scene), through, draw);
    const PrimitiveMap whole = mapOf(scene, light, 64, true),
                       part = mapOf(scene, light, 64, true, &panes);
    const PrimitiveLookup inWhole(whole), inPart(part);
    PaneTally tally;
    tally.listed = static_cast<double>(part.entries) / static_cast<double>(whole.entries);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 point = pointOn(panes[draw.below(panes.size())], draw);
        const bool isLit = inWhole.lights(point, false);
        tally.dark += isLit ? 0 : 1;
        tally.wrong += inPart.lights(point, false) == isLit ? 0 : 1;
    }
    return tally;
}

TEST(PrimitiveMapBuilding, ForPanesListsTheSameOnThemAndLittleElsewhere) {
    std::size_t dark = 0;
    double listed = 0.0;
    unsigned maps = 0;
    for (const Light& light : lights())
        for (unsigned seed = 0; seed < 4; ++seed) {
            const PaneTally tally = askPanes(light, seed, false);
            EXPECT_EQ(tally.wrong, 0u);
            dark += tally.dark;
            listed += tally.listed;
            ++maps;
        }
    EXPECT_GT(dark, 300u * maps);
    EXPECT_LT(listed, 0.3 * maps);
}

TEST(PrimitiveMapBuilding, ForPanesThatHoldTheLightListsTheSameOnThem) {
    std::size_t dark = 0;
    for (const Light& light : lights())
        for (unsigned seed = 0; light.position.w != 0.0 && seed < 4; ++seed) {
            const PaneTally tally = askPanes(light, seed, true);
            EXPECT_EQ(tally.wrong, 0u);
            dark += tally.dark;
        }
    EXPECT_GT(dark, 1000u);
}

TEST(PrimitiveMapBuilding, ListsNoSheetThatIsOne) {
    const PrimitiveMap map = mapOf(SceneBuilder().floor(2).scene(), sun({0.2, 1, 0.1}), 64, false);
    // Only texels at the rim have lists.
    std::size_t listed = 0, dark = 0;
    for (std::size_t i = 0; i < map.headers; ++i) {
        const glm::vec2 texel = test::pairAt(map.texels, i);
        listed += texel.y > 0.0f;
        dark += texel.x < neverDark;
    }
    EXPECT_LT(listed, 64u * 8u);
    EXPECT_GT(dark, 1000u);
}

/// Three triangles with four corners, one of which two facings share: up, down, up.
TEST(SidedTriangles, KeepTheirOrder) {
    Scene scene = SceneBuilder().triangle({0, 0, 0}, {1, 0, 0}, {0, 0, -1}).scene();
    Batch& batch = scene.batches.front();
    batch.geometry.edit().positions.emplace_back(1, 0, -1);
    batch.geometry.edit().normals.emplace_back(0, 1, 0);
    batch.geometry.edit().texcoords.emplace_back(0.0f);
    batch.geometry.edit().colors.emplace_back(1.0f);
    batch.geometry.edit().indices = {0, 1, 2, 1, 2, 3, 1, 3, 2};
    batch.geometry.edit().groups.front().indexCount = 9;
    const auto sided = sidedTriangles(batch, scene.materials, shapeOf(sun({0, 1, 0})));
    ASSERT_EQ(sided.size(), 1u);
    EXPECT_EQ(sided[0].lightSide, 0.0f);
    EXPECT_EQ(sided[0].vertices.size(), 7u); // 1, 2 and 3 twice
    ASSERT_EQ(sided[0].indices.size(), 9u);
    constexpr float sides[] = {1, -1, 1};
    for (std::size_t i = 0; i < 9; ++i) {
        const SidedVertex& vertex = sided[0].vertices.at(sided[0].indices[i]);
        EXPECT_EQ(vertex.vertex.position, batch.geometry->positions[batch.geometry->indices[i]])
            << i;
        EXPECT_EQ(vertex.lightSide, sides[i / 3]) << i;
    }
}

TEST(SidedTriangles, TakeNoBuffersWhereAllAreAlike) {
    const Scene scene = SceneBuilder().floor(2).scene();
    for (const double height : {1.0, -1.0, 0.0}) { // in the plane: grazed
        const auto sided =
            sidedTriangles(scene.batches[0], scene.materials, shapeOf(sun({1, height, 0})));
        EXPECT_EQ(sided[0].lightSide, height > 0.0 ? 1.0f : height < 0.0 ? -1.0f : 2.0f);
        EXPECT_TRUE(sided[0].vertices.empty() && sided[0].indices.empty());
    }
}

} // namespace
} // namespace edgeshade::test
