#include "src/scene/load.hpp"
#include "src/shadow/layers/layer_search.hpp"
#include "src/shadow/view/kept_layers.hpp"
#include "tests/lab/line_counts.hpp"
#include "tests/support/bounded_layers.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/lights.hpp"
#include "tests/support/scene_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

using test::LineCounts;
using test::Random;
using test::SceneBuilder;
using test::Soup;

constexpr std::size_t anyLimit = 100'000;

Batch batchOf(const Soup& soup, const glm::dmat4& worldFromBatch) {
    SceneBuilder builder;
    for (std::size_t i = 0; i < soup.indices.size(); i += 3)
        builder.triangle(soup.positions[soup.indices[i]], soup.positions[soup.indices[i + 1]],
                         soup.positions[soup.indices[i + 2]]);
    Batch batch = builder.scene().batches.front();
    batch.worldFromBatch = worldFromBatch;
    return batch;
}

Scene sceneOf(const Soup& soup, const glm::dmat4& worldFromBatch = glm::dmat4(1.0)) {
    Scene scene = SceneBuilder().scene();
    scene.batches = {batchOf(soup, worldFromBatch)};
    return scene;
}

/// Random triangles, some of them large, thin, doubled or flipped.
Soup randomTriangles(Random& random, int count) {
    Soup soup;
    const auto add = [&](const glm::dvec3& corner) {
        soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
        soup.positions.emplace_back(corner);
    };
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 a = random.inCube();
        const double size = random.below(5) == 0 ? 2.0 : 0.4;
        glm::dvec3 b = a + size * random.inCube(), c = a + size * random.inCube();
        if (random.below(8) == 0) c = glm::mix(a, b, 0.3) + 1e-7 * random.inCube();
        for (const glm::dvec3& corner : {a, b, c})
            add(corner);
        if (random.below(6) == 0)
            for (const glm::dvec3& corner : {a, random.below(2) == 0 ? b : c, c})
                add(corner);
        if (random.below(6) == 0)
            for (const glm::dvec3& corner : {b, a, c})
                add(corner);
    }
    return soup;
}

/// Sheets of eight quads each.
Scene sheets(int count) {
    SceneBuilder builder;
    for (int i = 0; i < count; ++i)
        for (int part = 0; part < 8; ++part) {
            const float y = 0.01f * static_cast<float>(i), x = 0.25f * static_cast<float>(part);
            builder.quad({x, y, 1}, {x + 0.25f, y, 1}, {x + 0.25f, y, -1}, {x, y, -1});
        }
    return builder.scene();
}

Batch smallBox() {
    return SceneBuilder().box({0, 3, 0}, {1, 4, 1}).scene().batches.front();
}

/// Boxes beside sheets, where a high sun shadows nothing, and below them.
std::pair<Box, Box> besideAndBelow() {
    Box beside, below;
    beside.add(glm::dvec3(50.0, -1.0, 0.0));
    beside.add(glm::dvec3(51.0, 0.0, 1.0));
    below.add(glm::dvec3(0.0, -2.0, -0.5));
    below.add(glm::dvec3(2.0, -1.0, 0.5));
    return {beside, below};
}

/// Meshes of every kind.
Soup anyMesh(Random& random) {
    const auto size = static_cast<std::size_t>(40 + random.below(160));
    switch (random.below(4)) {
    case 0:
        return test::hillyGrid(size);
    case 1:
        return test::manyBoxes(size);
    case 2:
        return test::tangle(size);
    default:
        return randomTriangles(random, static_cast<int>(size / 2));
    }
}

/// A light as hardLights() gives it for a mesh, in the world.
Light lightAt(const glm::vec4& inBatch, const glm::dmat4& worldFromBatch) {
    Light light;
    light.position = worldFromBatch * glm::dvec4(inBatch);
    return light;
}

/// Searches with limits from just below the truth on. Returns the number of bounds shown.
int expectNoneBelow(std::size_t truth, const Scene& scene, const Light& light) {
    const auto records = buildPlanePairs(scene, false);
    const LayerCasters casters{scene, records};
    LayerSearch search;
    int shown = 0;
    for (const std::size_t limit : {truth - 1, truth, truth + 2, 3 * truth + 5, anyLimit}) {
        if (truth == 0 && limit == truth - 1) continue;
        const auto most = search.bySilhouettes(casters, light, limit);
        if (!most) continue;
        ++shown;
        EXPECT_GE(*most, truth) << "limit " << limit;
        EXPECT_LE(*most, limit);
    }
    return shown;
}

TEST(LayerSearch, IsNeverBelowTheTruth) {
    Random random(48);
    int searches = 0, shown = 0;
    for (int i = 0; i < 200; ++i) {
        const Soup soup = anyMesh(random);
        glm::dmat4 place(1.0);
        if (i % 4 == 1) place = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, -0.5, 2.0));
        if (i % 4 == 2) {
            place = glm::translate(glm::dmat4(1.0), glm::dvec3(5e6, -3e5, 2e6));
            place = glm::rotate(place, 1.0, glm::dvec3(1.0, 2.0, 3.0));
            place[1] += 0.7 * place[0]; // sheared
        }
        if (i % 4 == 3) place = glm::scale(glm::dmat4(1.0), glm::dvec3(i % 8 == 3 ? 1e-9 : 1e9));
        const Scene scene = sceneOf(soup, place);
        const WeldedMesh mesh = weld(soup.positions, soup.indices);
        for (const glm::vec4& inBatch : test::hardLights(mesh, 6, static_cast<unsigned>(i))) {
            SCOPED_TRACE(testing::Message() << "mesh " << i << ", light " << searches % 6);
            const Light light = lightAt(inBatch, place);
            const std::size_t truth = LineCounts(scene, false, light, 48).most();
            shown += expectNoneBelow(truth, scene, light);
            ++searches;
        }
    }
    // Two or three of the five limits are high enough to be shown.
    EXPECT_GT(shown, 2 * searches);
}

TEST(LayerSearch, CountsMeshesOnceWhereverTheyAre) {
    Random random(5);
    Scene scene = sceneOf(test::manyBoxes(60));
    const Batch first = scene.batches.front();
    for (int i = 0; i < 30; ++i) {
        Batch& place = scene.batches.emplace_back(first); // shares its geometry
        place.worldFromBatch = glm::translate(glm::dmat4(1.0), 20.0 * random.inCube());
        if (i % 3 == 0)
            place.worldFromBatch = glm::scale(place.worldFromBatch, glm::dvec3(-1.0, 1.0, 1.0));
    }
    for (const Light& light :
         {test::sun({0.3, 1, 0.2}), test::pointLight({3, 2, 1}), test::pointLight({60, 80, 40})}) {
        const std::size_t truth = LineCounts(scene, false, light, 200).most();
        EXPECT_GE(truth, 6u);
        EXPECT_GE(expectNoneBelow(truth, scene, light), 2);
    }
}

TEST(LayerSearch, HiddenBatchesDoNotCount) {
    Scene scene = sceneOf(test::manyBoxes(300));
    scene.batches.push_back(scene.batches.front());
    scene.batches.back().hidden = true;
    scene.batches.back().worldFromBatch = glm::dmat4(0.0);
    const auto records = buildPlanePairs(scene, false);
    const Scene alone = sceneOf(test::manyBoxes(300));
    const Light light = test::sun({0.3, 1, 0.2});
    EXPECT_EQ(LayerSearch().bySilhouettes({scene, records}, light, anyLimit),
              LayerSearch().bySilhouettes({alone, buildPlanePairs(alone, false)}, light, anyLimit));
}

TEST(LayerSearch, CastersBeyondALampsRangeDoNotCount) {
    Scene scene = sheets(20);
    scene.batches.push_back(sheets(300).batches.front());
    scene.batches.back().worldFromBatch =
        glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 100.0, 0.0));
    const auto records = buildPlanePairs(scene, false);
    Light lamp = test::pointLight({1.1, -3, 0.1});
    EXPECT_FALSE(LayerSearch().bySilhouettes({scene, records}, lamp, 255));
    lamp.range = 20.0;
    EXPECT_EQ(LineCounts(scene, false, lamp, 100).most(), 20u);
    const auto most = LayerSearch().bySilhouettes({scene, records}, lamp, 255);
    ASSERT_TRUE(most);
    EXPECT_GE(*most, 20u);
    EXPECT_LE(*most, 60u);
}

// Bumps of a sheet that is taken for flat turn towards the light and away from it, and the sheet
// has one facing.
/// The casting triangles that the segment from the light to a point passes through.
std::size_t crossedBetween(const Scene& scene, const Light& light, const glm::dvec3& to) {
    std::size_t crossed = 0;
    const glm::dvec3 toLight =
        glm::dvec3(light.position) - light.position.w * to; // of any length for a sun
    for (const Batch& batch : scene.batches)
        for (std::size_t i = 0; i < batch.geometry->indices.size(); i += 3) {
            glm::dvec3 at[3];
            for (std::size_t c = 0; c < 3; ++c)
                at[c] =
                    glm::dvec3(batch.worldFromBatch *
                               glm::dvec4(batch.geometry->positions[batch.geometry->indices[i + c]],
                                          1.0)) -
                    to;
            double side[3];
            for (std::size_t c = 0; c < 3; ++c)
                side[c] = glm::dot(toLight, glm::cross(at[c], at[(c + 1) % 3]));
            const double all = side[0] + side[1] + side[2];
            if (all == 0.0 || side[0] * all <= 0.0 || side[1] * all <= 0.0 || side[2] * all <= 0.0)
                continue;
            const double along = glm::dot(at[0], glm::cross(at[1], at[2])) / all;
            crossed += along > 0.0 && (light.position.w == 0.0 || along < 1.0);
        }
    return crossed;
}

TEST(LayerSearch, CountsWhatShadowsTheReceivers) {
    Random random(54);
    std::size_t smaller = 0, most = 0;
    for (int i = 0; i < 120; ++i) {
        SCOPED_TRACE(testing::Message() << "mesh " << i);
        const Scene scene = sceneOf(anyMesh(random));
        const Box all = worldBounds(scene);
        const auto anywhere = [&] {
            return all.center() + 0.7 * (all.high - all.low) * random.inCube();
        };
        Box receivers;
        const glm::dvec3 middle = anywhere();
        receivers.add(middle);
        receivers.add(middle + random.uniform(0.0, 0.3) * (all.high - all.low));
        const glm::dvec3 place = anywhere();
        const Light light = i % 2 == 0 ? test::sun(glm::dvec3(random.inCube()))
                                       : test::pointLight(i % 4 == 1 ? place : middle);
        const auto records = buildPlanePairs(scene, false);
        LayerSearch search;
        const auto bound = search.bySilhouettes({scene, records}, light, anyLimit, receivers);
        const auto whole = search.bySilhouettes({scene, records}, light, anyLimit);
        ASSERT_TRUE(bound && whole);
        EXPECT_LE(*bound, *whole + 2);
        smaller += *bound < *whole;
        for (int point = 0; point < 40; ++point) {
            const glm::dvec3 share = 0.5 + 0.5 * random.inCube();
            const glm::dvec3 to = receivers.low + share * (receivers.high - receivers.low);
            const std::size_t truth = crossedBetween(scene, light, to);
            EXPECT_GE(*bound, truth);
            most = std::max(most, truth);
        }
    }
    EXPECT_GT(smaller, 30u) << "casters elsewhere should be left out";
    EXPECT_GT(most, 5u);
}

TEST(LayerSearch, LeavesOutPlacesThatShadowNoReceiver) {
    Scene scene = sheets(150);
    Batch far = scene.batches.front();
    far.worldFromBatch = glm::translate(glm::dmat4(1.0), glm::dvec3(500.0, 0.0, 0.0));
    scene.batches.push_back(far);
    const auto records = buildPlanePairs(scene, false);
    Box receivers;
    receivers.add(glm::dvec3(495.0, -100.0, -5.0));
    receivers.add(glm::dvec3(505.0, -90.0, 5.0));
    LayerSearch search;
    const auto here =
        search.bySilhouettes({scene, records}, test::sun({0.01, 1, 0.02}), 255, receivers);
    ASSERT_TRUE(here);
    EXPECT_GE(*here, 150u);
    receivers.low.x = 200.0;
    receivers.high.x = 300.0;
    const auto nothing =
        search.bySilhouettes({scene, records}, test::sun({0.01, 1, 0.02}), 255, receivers);
    ASSERT_TRUE(nothing);
    EXPECT_EQ(*nothing, 0u);
}

TEST(LayerSearch, TakesStepsAheadWhichChangeNoBound) {
    const Soup hills = test::hillyGrid(50'000);
    Scene scene = sceneOf(hills);
    for (const double x : {200.0, 400.0})
        scene.batches.push_back(
            batchOf(hills, glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0, 0))));
    scene.batches.push_back(smallBox());
    const auto records = buildPlanePairs(scene, false);
    ASSERT_GT(3 * records[0]->caps.size(), std::size_t{1} << 17) << "two steps of looks";
    const LayerCasters casters{scene, records};
    for (const Light& light : {test::sun({0.3, 0.4, 0.2}), test::pointLight({150, 40, 90})}) {
        LayerSearch search;
        int steps = 0;
        while (!search.lookAhead(casters, light, 255) && steps < 20)
            ++steps;
        EXPECT_EQ(steps, 3) << "a first search, and two looks";
        EXPECT_EQ(search.bySilhouettes(casters, light, 255),
                  LayerSearch().bySilhouettes(casters, light, 255));
        EXPECT_TRUE(search.lookAhead(casters, light, 255)) << "all of it is kept";
    }
    EXPECT_TRUE(LayerSearch().lookAhead(casters, test::sun({0, 1, 0}), scene.triangleCount()))
        << "no search is needed";
}

TEST(KeptLayers, TakeStepsAheadOnlyForBoundsThatAreNotKnown) {
    Scene scene = sheets(200);
    scene.batches.push_back(smallBox());
    const auto records = buildPlanePairs(scene, false);
    const LayerCasters casters{scene, records};
    const auto [beside, below] = besideAndBelow();
    std::vector<FrameLight> lights(1);
    lights[0].light = test::sun({0.01, 1, 0.02});
    KeptLayers layers, hidden;
    EXPECT_FALSE(layers.lookAhead(casters, lights[0], beside)) << "a first search";
    layers.fill(casters, lights, beside);
    EXPECT_TRUE(layers.lookAhead(casters, lights[0], beside));
    EXPECT_FALSE(layers.lookAhead(casters, lights[0], below)) << "a first look";
    EXPECT_TRUE(layers.lookAhead(casters, lights[0], below));
    lights[0].drawn = false;
    EXPECT_TRUE(hidden.lookAhead(casters, lights[0], below));
}

TEST(KeptLayers, OfALightAtRestHoldWhereverTheEyeLooks) {
    const Scene scene = sheets(200);
    const auto records = buildPlanePairs(scene, false);
    const LayerCasters casters{scene, records};
    const auto [beside, below] = besideAndBelow();
    std::vector<FrameLight> lights(1);
    lights[0].light = test::sun({0.01, 1, 0.02});
    KeptLayers layers;
    EXPECT_TRUE(layers.fill(casters, lights, beside));
    EXPECT_EQ(lights[0].layers.most, 0u) << "nothing shadows what is visible";
    EXPECT_FALSE(layers.fill(casters, lights, beside));
    EXPECT_TRUE(layers.fill(casters, lights, below));
    EXPECT_GE(lights[0].layers.most, 200u);
    EXPECT_FALSE(layers.fill(casters, lights, beside)) << "this bound holds everywhere";
    lights[0].light = test::sun({0.02, 1, 0.02});
    EXPECT_TRUE(layers.fill(casters, lights, below));
    EXPECT_GE(lights[0].layers.most, 200u);
}

TEST(KeptLayers, OfMoversAreKeptToo) {
    const Scene scene = sheets(200);
    const auto records = buildPlanePairs(scene, false);
    const LayerCasters casters{scene, records};
    const Box below = besideAndBelow().second;
    FrameLight light;
    light.light = test::sun({0.01, 1, 0.02});
    light.animatedAlone = true;
    KeptLayers layers;
    EXPECT_TRUE(layers.fillMovers(casters, light, below));
    EXPECT_GE(light.layers.most, 200u);
    light.layers = {};
    EXPECT_FALSE(layers.fillMovers(casters, light, below));
    EXPECT_GE(light.layers.most, 200u);
    layers.clear();
    EXPECT_TRUE(layers.fillMovers(casters, light, below));
}

TEST(LayerSearch, SheetsTakenForFlatCountAsTheyAre) {
    Soup soup;
    for (int layer = 0; layer < 30; ++layer) {
        const Soup sheet = test::hillyGrid(200);
        const auto first = static_cast<std::uint32_t>(soup.positions.size());
        for (const glm::vec3& p : sheet.positions)
            soup.positions.push_back(p + glm::vec3(0.0f, 0.01f * static_cast<float>(layer), 0.0f));
        for (const std::uint32_t index : sheet.indices)
            soup.indices.push_back(first + index);
    }
    const Scene scene = sceneOf(soup);
    const auto records = buildPlanePairs(scene, false, 40.0);
    Random random(3);
    int shown = 0;
    for (int i = 0; i < 20; ++i) {
        const Light light = test::sun({random.uniform(-1, 1), 0.3, random.uniform(-1, 1)});
        const std::size_t truth = LineCounts(scene, false, light, 100).most();
        for (const std::size_t limit : {truth - 1, 2 * truth, anyLimit}) {
            const auto most = LayerSearch().bySilhouettes({scene, records}, light, limit);
            if (!most) continue;
            ++shown;
            EXPECT_GE(*most, truth);
        }
    }
    EXPECT_GE(shown, 20);
}

// A sun sinks to the horizon of a sheet with bumps. No plane is within rounding of it.
TEST(LayerSearch, SheetsTakenForFlatTellWhenTheyTurnUncertain) {
    const auto records = buildPlanePairs(sceneOf(test::hillyGrid(200)), false, 40.0);
    const CasterFacings facings(*records[0]);
    FollowedCasters followed;
    int turned = 0;
    for (int place = 0; place < 400; ++place) {
        const double height = 1.0 - 0.003 * place;
        const LightInBatch light = lightInBatch(test::sun({0.8, height, 0.5}), glm::dmat4(1.0));
        const std::vector<std::int8_t> before = followed.facings.facings;
        facings.follow(light, followed);
        FollowedCasters alone;
        facings.follow(light, alone);
        EXPECT_EQ(followed.facings.facings, alone.facings.facings) << place;
        for (std::size_t cap = 0; cap < before.size(); ++cap) {
            if (followed.facings.facings[cap] == before[cap]) continue;
            ++turned;
            EXPECT_EQ(followed.facings.changedAt[cap / FollowedFacings::run], followed.facings.look)
                << place;
        }
    }
    EXPECT_GT(turned, 100);
}

/// Searches along the ways of some lights, and for each place by a search of its own.
void expectSameOnTheWay(const LayerCasters& casters, Scene& scene, Random& random) {
    LayerSearch search;
    Light light = test::sun({0.3, 1, 0.2});
    for (int place = 0; place < 40; ++place) {
        switch (random.below(10)) {
        case 0:
            light = test::sun(random.inCube());
            break;
        case 1:
            light = test::pointLight(20.0 * random.inCube());
            break;
        case 2:
            scene.batches[0].worldFromBatch = glm::rotate(scene.batches[0].worldFromBatch,
                                                          random.magnitude(-5, 0), random.inCube());
            break;
        case 3:
            scene.batches[1].hidden = !scene.batches[1].hidden;
            break;
        default:
            light.position += glm::dvec4(random.magnitude(-6, -1) * random.inCube(), 0.0);
        }
        EXPECT_EQ(search.bySilhouettes(casters, light, anyLimit),
                  LayerSearch().bySilhouettes(casters, light, anyLimit))
            << "place " << place;
    }
}

TEST(LayerSearch, OnALightsWayIsAsIfThatPlaceWereTheFirst) {
    Random random(59);
    for (int i = 0; i < 40; ++i) {
        SCOPED_TRACE(testing::Message() << "mesh " << i);
        Scene scene = sceneOf(anyMesh(random));
        scene.batches.push_back(scene.batches.front()); // shares its records
        scene.batches[1].worldFromBatch =
            glm::translate(glm::dmat4(1.0), 5.0 * glm::dvec3(random.inCube()));
        // Every other mesh has planes that are off their triangles.
        const auto records = buildPlanePairs(scene, false, i % 2 == 0 ? 0.0 : 20.0);
        expectSameOnTheWay({scene, records}, scene, random);
    }
}

// Two triangles meet at a sheet's diagonal, which is no silhouette.
TEST(LayerSearch, GroupsAreMadeOnlyWhereTheTruthAsksForThem) {
    for (const int count : {100, 250, 300}) {
        const Scene scene = sheets(count);
        const auto records = buildPlanePairs(scene, false);
        for (const Light& light : {test::pointLight({1.3, 9, 0.1}), test::sun({0.1, 1, 0.2}),
                                   test::pointLight({1.5, 0.333, 0.1})}) {
            SCOPED_TRACE(count);
            const LayerBound bound = test::boundLayers({scene, records}, light, 255);
            const std::size_t truth = LineCounts(scene, false, light, 60).most();
            EXPECT_GE(bound.most, truth);
            EXPECT_EQ(bound.groupCount > 1, truth > 255);
            EXPECT_EQ(bound.groupOf.empty(), truth <= 255);
        }
    }
}

TEST(LayerSearch, GroupsAreThoseOfTriangles) {
    const Scene scene = sheets(280);
    const auto records = buildPlanePairs(scene, false);
    const std::vector<Light> lights{test::pointLight({1.5, 0.01, 0.1}), test::sun({0.1, 1, 0.2})};
    const LayerBound bound = test::boundLayers({scene, records}, lights, 255);
    const LayerBound byTriangles = boundByTriangles(scene, false, lights, 255);
    EXPECT_GT(bound.groupCount, 1u);
    EXPECT_EQ(bound.groupOf, byTriangles.groupOf);
    EXPECT_EQ(bound.most, byTriangles.most);
}

TEST(LayerSearch, SeveralLightsHaveTheLargestBound) {
    const Scene scene = sheets(200);
    const auto records = buildPlanePairs(scene, false);
    const std::vector<Light> lights{test::pointLight({0.3, 9, 0.1}), test::sun({1, 0.01, 0.2})};
    std::size_t most = 0;
    for (const Light& light : lights)
        most = std::max(most, test::boundLayers({scene, records}, light, 255).most);
    EXPECT_EQ(test::boundLayers({scene, records}, lights, 255).most, most);
}

// A new pose has new records, perhaps at the address of earlier ones.
TEST(LayerSearch, KeepsNothingOfRecordsThatAreGone) {
    LayerSearch search;
    for (const int count : {150, 40, 220, 90}) {
        const Scene scene = sheets(count);
        const auto records = buildPlanePairs(scene, false);
        const auto most = search.bySilhouettes({scene, records}, test::sun({0.1, 1, 0.2}), 255);
        ASSERT_TRUE(most);
        EXPECT_GE(*most, static_cast<std::size_t>(count));
        EXPECT_LE(*most, 2 * static_cast<std::size_t>(count) + 10);
    }
}

TEST(KeptChains, TellRecordsApartThatFollowEachOtherAtOneAddress) {
    KeptChains chains;
    PlanePairShadow place;
    const auto chainOf = [&](int count) {
        place = *buildPlanePairs(sheets(count), false)[0];
        const std::shared_ptr<const PlanePairShadow> records(&place, [](const auto*) {});
        EXPECT_EQ(chains.of(records), chains.of(records));
        return chains.of(records);
    };
    const auto first = chainOf(150), second = chainOf(40);
    EXPECT_NE(first, second);
}

// One of the searches sits out while records go and others come, perhaps at the same addresses.
TEST(LayerSearch, SearchesThatShareChainsBoundAlike) {
    const auto chains = std::make_shared<KeptChains>();
    LayerSearch search(chains), resting(chains);
    const Light sun = test::sun({0.1, 1, 0.2});
    for (const int count : {150, 40, 220, 90, 60}) {
        const Scene scene = sheets(count);
        const auto records = buildPlanePairs(scene, false);
        for (const auto& of : records)
            EXPECT_EQ(&chains->of(of)->shadow(), of.get());
        const auto most = LayerSearch().bySilhouettes({scene, records}, sun, 255);
        EXPECT_EQ(search.bySilhouettes({scene, records}, sun, 255), most);
        if (count == 40) continue;
        EXPECT_EQ(resting.bySilhouettes({scene, records}, sun, 255), most);
    }
}

/// The shared models; none: they are not there.
std::vector<std::filesystem::path> modelFiles() {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::is_directory(EDGESHADE_SHARED_SCENES)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(EDGESHADE_SHARED_SCENES))
        if (entry.path().extension() == ".glb") files.push_back(entry.path());
    return files;
}

TEST(LayerSearch, ModelsNeedNoGroups) {
    if (modelFiles().empty())
        GTEST_SKIP() << EDGESHADE_SHARED_SCENES << " is not there, so no bounds of its models";
    for (const std::filesystem::path& file : modelFiles()) {
        SCOPED_TRACE(file.stem());
        const LoadedScene loaded = loadScene(file, std::nullopt);
        const Box bounds = worldBounds(loaded.scene);
        const double size = bounds.diagonal();
        LayerSearch search;
        for (const Light& light :
             {test::sun({0.4, 1, 0.3}), test::sun({-0.9, 0.25, 0.35}), test::sun({0, 1, 0}),
              test::pointLight(bounds.center() + size * glm::dvec3(0.3, 0.6, 0.2)),
              test::pointLight(bounds.center() + 0.05 * size),
              test::pointLight(glm::dvec3(
                  loaded.scene.batches.front().worldFromBatch *
                  glm::dvec4(loaded.scene.batches.front().geometry->positions.front(), 1.0)))}) {
            const std::size_t truth = LineCounts(loaded.scene, false, light, 128).most();
            EXPECT_GE(truth, 4u);
            const auto most = search.bySilhouettes(loaded.layerCasters(), light, 255);
            if (most)
                EXPECT_GE(*most, truth);
            else
                EXPECT_EQ(light.position.x, 0.0) << "shown for lights in general position";
            EXPECT_FALSE(search.bySilhouettes(loaded.layerCasters(), light, truth - 1));
        }
    }
}

/// A light of a model: suns, lamps around and inside, and lamps on vertices and a hair off.
Light modelLight(const Scene& scene, const Box& bounds, Random& random, int i) {
    const glm::dvec3 direction(random.inCube());
    if (i % 4 == 0) return test::sun(direction);
    if (i % 4 == 1) return test::pointLight(bounds.center() + bounds.diagonal() * direction);
    if (i % 4 == 2) return test::pointLight(bounds.center() + 0.3 * bounds.diagonal() * direction);
    const Batch& batch = scene.batches[static_cast<std::size_t>(
        random.below(static_cast<int>(scene.batches.size())))];
    const auto& positions = batch.geometry->positions;
    const glm::dvec3 vertex(
        batch.worldFromBatch *
        glm::dvec4(
            positions[static_cast<std::size_t>(random.below(static_cast<int>(positions.size())))],
            1.0));
    return test::pointLight(vertex + (i % 8 == 3 ? 0.0 : 1e-7 * bounds.diagonal()) * direction);
}

TEST(LongLayerSearch, IsNeverBelowTheTruthOfModels) {
    if (modelFiles().empty())
        GTEST_SKIP() << EDGESHADE_SHARED_SCENES << " is not there, so no bounds of its models";
    for (const std::filesystem::path& file : modelFiles()) {
        SCOPED_TRACE(file.stem());
        const LoadedScene loaded = loadScene(file, std::nullopt);
        const Box bounds = worldBounds(loaded.scene);
        Random random(53);
        LayerSearch search;
        int shown = 0;
        for (int i = 0; i < 100; ++i) {
            SCOPED_TRACE(testing::Message() << "light " << i);
            const Light light = modelLight(loaded.scene, bounds, random, i);
            const std::size_t truth = LineCounts(loaded.scene, false, light, 64).most();
            const auto most = search.bySilhouettes(loaded.layerCasters(), light, stencilLimit);
            if (!most) continue;
            EXPECT_GE(*most, truth);
            ++shown;
        }
        EXPECT_GT(shown, 75) << "groups only where the truth asks for them";
    }
}

} // namespace
} // namespace edgeshade
