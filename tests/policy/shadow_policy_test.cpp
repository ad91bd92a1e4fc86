// The rules that choose each light's technique, one row per rule.
#include "src/policy/shadow_policy.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace edgeshade {
namespace {

constexpr std::size_t plenty = std::numeric_limits<std::size_t>::max();

/// A resting light in a large, ordinary scene, on a processor that can do everything, with a free
/// choice.
struct Situation {
    PolicySettings settings{.asked = ShadowMethod::automatic};
    DeviceFacts device{.floatTables = true,
                       .textureUnits = 16,
                       .fragmentUniformVectors = 1024,
                       .isSoftware = true,
                       .hasDepthOfItsOwn = true,
                       .samples = 0};
    SceneFacts scene{.triangles = 100'000};
    LightFacts light;
    LookupFacts lookup;
    LookupOutcome built;

    ShadowPolicy policy() const { return {settings, device, scene}; }
    LightChoice choice() const { return policy().choose(light, lookup); }
};

using Change = std::function<void(Situation&)>;

LookupFacts usable() {
    return {true, true, "at rest"};
}

LookupFacts givenUp() {
    return {true, false, "casters are simplified"};
}

TEST(ShadowPolicy, ChoosesByTheFirstRuleThatApplies) {
    struct Row {
        const char* rule;
        Technique technique;
        const char* reason;
        Change change;
    };
    const auto asked = [](ShadowMethod method) {
        return [=](Situation& of) {
            of.settings.asked = method;
            of.lookup = usable();
        };
    };
    const std::vector<Row> rows{
        {"light without a shadow", Technique::none,
         "other lights are estimated to add more to the picture",
         [](Situation& of) { of.light.isShadowed = of.light.isDrawn = false; }},
        {"light out of sight", Technique::none, "it reaches no visible geometry",
         [](Situation& of) {
             of.light.isDrawn = false;
             of.lookup = usable();
         }},
        {"no shadows requested", Technique::none, "", asked(ShadowMethod::none)},
        {"shadow map requested", Technique::map, "", asked(ShadowMethod::map)},
        {"planar shadows requested", Technique::planar, "", asked(ShadowMethod::planar)},
        {"points requested", Technique::points, "", asked(ShadowMethod::irregularZBuffer)},
        {"volumes requested", Technique::volumes, "", asked(ShadowMethod::volumes)},
        {"lookup is built", Technique::lookup, "at rest", asked(ShadowMethod::primitiveMap)},
        {"lookup is built", Technique::lookup, "at rest", asked(ShadowMethod::automatic)},
        {"points cost less than volumes", Technique::points,
         "it has no primitive map, and filling volumes is estimated to take longer",
         [](Situation&) {}},
        {"points cost less than volumes", Technique::points,
         "it has no primitive map, and filling volumes is estimated to take longer",
         [](Situation& of) { of.lookup = givenUp(); }},
        {"lookup was given up", Technique::volumes, "casters are simplified",
         [](Situation& of) {
             of.lookup = givenUp();
             of.device.isSoftware = false;
         }},
        {"light with an extent", Technique::volumes, "it has an extent",
         [](Situation& of) {
             of.light.hasExtent = true;
             of.device.isSoftware = false;
         }},
        {"lookup is not built yet", Technique::volumes, "its primitive map is not built",
         [](Situation& of) { of.device.isSoftware = false; }},
        {"light that moves", Technique::volumes, "it moves",
         [](Situation& of) {
             of.light.rests = false;
             of.device.isSoftware = false;
         }},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.rule);
        Situation situation;
        row.change(situation);
        const LightChoice choice = situation.choice();
        EXPECT_EQ(choice.rule, row.rule);
        EXPECT_EQ(wordFor(choice.technique), std::string(wordFor(row.technique)));
        EXPECT_EQ(situation.policy().reasonFor(situation.light, situation.lookup), row.reason);
    }
}

TEST(ShadowPolicy, AsksPointsOnlyWhereTheProcessorDrawsManyTriangles) {
    const std::vector<Change> against{
        [](Situation& of) { of.device.isSoftware = false; },
        [](Situation& of) { of.device.samples = 4; },
        [](Situation& of) { of.device.hasDepthOfItsOwn = false; },
        [](Situation& of) { of.scene.triangles = leastTrianglesForPoints - 1; },
        [](Situation& of) { of.settings.planePairs = false; },
        [](Situation& of) { of.settings.maskScale = 2; },
        [](Situation& of) { of.settings.asked = ShadowMethod::primitiveMap; }};
    EXPECT_EQ(Situation{}.choice().technique, Technique::points);
    EXPECT_TRUE(Situation{}.policy().mayAskPoints());
    for (const Change& change : against) {
        Situation situation;
        change(situation);
        EXPECT_EQ(situation.choice().technique, Technique::volumes);
        EXPECT_EQ(situation.policy().mayAskPoints(),
                  situation.scene.triangles < leastTrianglesForPoints);
    }
}

TEST(ShadowPolicy, CountsWhatALookupDoesNotHold) {
    Situation situation;
    situation.lookup = usable();
    EXPECT_EQ(situation.choice().counted, Technique::none);
    situation.scene.anyAnimated = true;
    EXPECT_EQ(situation.choice().counted, Technique::points);
    situation.device.isSoftware = false;
    EXPECT_EQ(situation.choice().counted, Technique::volumes);
    situation.lookup = {};
    EXPECT_EQ(situation.choice().counted, Technique::volumes);
}

TEST(ShadowPolicy, BuildsLookupsForTheLightsThatTakePart) {
    struct Row {
        const char* what;
        bool kept, wanted;
        Change change;
    };
    const auto asked = [](ShadowMethod method) {
        return [=](Situation& of) { of.settings.asked = method; };
    };
    const std::vector<Row> rows{
        {"a light at rest", true, true, [](Situation&) {}},
        {"a light that moves", false, false, [](Situation& of) { of.light.rests = false; }},
        {"a light that moves, by name", true, true,
         [](Situation& of) {
             of.settings.asked = ShadowMethod::primitiveMap;
             of.light.rests = false;
         }},
        {"a light that moves, by name, beside drawing", false, false,
         [](Situation& of) {
             of.settings.asked = ShadowMethod::primitiveMap;
             of.settings.inBackground = true;
             of.light.rests = false;
         }},
        {"a light out of sight", true, false, [](Situation& of) { of.light.isDrawn = false; }},
        {"a light without a shadow", true, false,
         [](Situation& of) { of.light.isShadowed = false; }},
        {"an extent", false, false, [](Situation& of) { of.light.hasExtent = true; }},
        {"an extent, by name", true, true,
         [](Situation& of) {
             of.settings.asked = ShadowMethod::primitiveMap;
             of.light.hasExtent = true;
         }},
        {"an extent, beside drawing", true, true,
         [](Situation& of) {
             of.settings.inBackground = true;
             of.light.hasExtent = true;
         }},
        {"volumes", false, false, asked(ShadowMethod::volumes)},
        {"maps", false, false, asked(ShadowMethod::map)},
        {"points", false, false, asked(ShadowMethod::irregularZBuffer)},
        {"volumes, and something see-through", true, true,
         [](Situation& of) {
             of.settings.asked = ShadowMethod::volumes;
             of.settings.seeThroughReceives = true;
         }},
        {"volumes, and something see-through elsewhere", true, false,
         [](Situation& of) {
             of.settings.asked = ShadowMethod::volumes;
             of.settings.seeThroughReceives = true;
             of.light.reachesSeeThrough = false;
         }},
        {"maps, and something see-through", false, false,
         [](Situation& of) {
             of.settings.asked = ShadowMethod::map;
             of.settings.seeThroughReceives = true;
         }},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.what);
        Situation situation;
        row.change(situation);
        const LookupWish wish = situation.policy().lookupWish(situation.light);
        EXPECT_EQ(wish.isKept, row.kept);
        EXPECT_EQ(wish.isWanted, row.wanted);
    }
}

TEST(ShadowPolicy, SaysWhatKeepsALightFromBeingLookedUp) {
    struct Row {
        const char* why;
        Change change;
    };
    const auto edges = [](std::size_t count) { return [=] { return count; }; };
    const std::vector<Row> rows{
        {"", [](Situation&) {}},
        {"the GL can't sample float textures exactly",
         [](Situation& of) { of.device.floatTables = false; }},
        {"", [](Situation& of) { of.device.textureUnits = 4; }},
        {"", [](Situation& of) { of.scene.cutoutsCast = true; }},
        {"the GL has too few texture units for cutouts",
         [](Situation& of) {
             of.scene.cutoutsCast = true;
             of.device.textureUnits = 5;
         }},
        {"casters are simplified", [](Situation& of) { of.scene.simplified = true; }},
        {"", [](Situation& of) { of.scene.anyAnimated = true; }},
        {"all casters are animated", [](Situation& of) { of.scene.allAnimated = true; }},
        {"some casters are alpha-tested", [](Situation& of) { of.scene.alphaTested = true; }},
        {"", [](Situation& of) { of.light.hasRange = of.light.isSpot = true; }},
        {"", [](Situation& of) { of.light.hasExtent = true; }},
        {"the GL has too few uniforms for a light's points",
         [](Situation& of) {
             of.light.hasExtent = true;
             of.device.fragmentUniformVectors = 63;
         }},
        {"it has both an extent and a range",
         [](Situation& of) { of.light.hasExtent = of.light.hasRange = true; }},
        {"it is a spot with an extent",
         [](Situation& of) { of.light.hasExtent = of.light.isSpot = true; }},
        {"it has an extent, and cutouts cast shadows",
         [](Situation& of) { of.light.hasExtent = of.scene.cutoutsCast = true; }},
        {"it has an extent, and casters are animated",
         [](Situation& of) { of.light.hasExtent = of.scene.anyAnimated = true; }},
        {"volumes of 1000 silhouette edges cost less",
         [=](Situation& of) { of.light.silhouetteEdges = edges(1000); }},
        {"", [=](Situation& of) { of.light.silhouetteEdges = edges(1001); }},
        {"",
         [=](Situation& of) {
             of.light.silhouetteEdges = edges(1000);
             of.settings.asked = ShadowMethod::primitiveMap;
         }},
        {"",
         [=](Situation& of) {
             of.light.silhouetteEdges = edges(1000);
             of.scene.cutoutsCast = true;
         }},
        {"",
         [=](Situation& of) {
             of.light.silhouetteEdges = edges(1000);
             of.settings.inBackground = of.settings.seeThroughReceives = true;
         }},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.why);
        Situation situation;
        row.change(situation);
        EXPECT_EQ(situation.policy().lookupObstacle(situation.light), row.why);
    }
}

TEST(ShadowPolicy, TriesNoLookupWithoutRoom) {
    const ShadowPolicy policy = Situation{}.policy();
    EXPECT_EQ(policy.roomObstacle(leastLookupBytes - 1),
              "other lights' primitive maps leave no memory for it");
    EXPECT_EQ(policy.roomObstacle(leastLookupBytes), "");
}

TEST(ShadowPolicy, CountsSilhouettesOnlyWhereTheyDecide) {
    Situation situation;
    situation.light.silhouetteEdges = []() -> std::size_t {
        ADD_FAILURE() << "counted";
        return 0;
    };
    situation.scene.simplified = true;
    situation.policy().lookupObstacle(situation.light);
    situation.scene.simplified = false;
    situation.settings.asked = ShadowMethod::primitiveMap;
    situation.policy().lookupObstacle(situation.light);
}

TEST(ShadowPolicy, RefusesLookupsWhoseListsAreLong) {
    Situation situation;
    situation.built.meanList = 100.0;
    EXPECT_EQ(situation.policy().lookupRefusal(situation.built), "");
    situation.built.meanList = 131.4;
    EXPECT_EQ(situation.policy().lookupRefusal(situation.built),
              "volumes cost less than lists of 131 triangles");
    situation.settings.asked = ShadowMethod::primitiveMap;
    EXPECT_EQ(situation.policy().lookupRefusal(situation.built), "");
    situation.built.fault = "it takes too much memory";
    EXPECT_EQ(situation.policy().lookupRefusal(situation.built), situation.built.fault);
}

TEST(ShadowPolicy, KnowsScenesThatNeedNoLookup) {
    Situation situation;
    EXPECT_FALSE(situation.policy().mayLookUp(fewSilhouettes));
    EXPECT_TRUE(situation.policy().mayLookUp(fewSilhouettes + 1));
    situation.scene.cutoutsCast = true;
    EXPECT_TRUE(situation.policy().mayLookUp(0));
    situation.scene.simplified = true;
    EXPECT_FALSE(situation.policy().mayLookUp(plenty));
    situation = {};
    situation.settings.asked = ShadowMethod::primitiveMap;
    EXPECT_TRUE(situation.policy().mayLookUp(0));
}

} // namespace
} // namespace edgeshade
