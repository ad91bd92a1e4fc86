#include "src/cli/tradeoff_family.hpp"
#include "src/cli/tradeoff_settings.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace edgeshade::cli {
namespace {

TEST(TradeoffFamily, FollowsFromWhatTheSettingSays) {
    const std::pair<const char*, const char*> cases[] = {
        {"shadows=volumes", "volumes"},
        {"mask-scale=1/2", "coarser masks"},
        {"shadows=volumes,layout=published,instancing=off", "volumes, published"},
        {"shadows=volumes,multiplicity=three-edge", "volumes, published"},
        {"shadows=volumes,layout=brute-force,count=z-pass", "volumes, brute-force"},
        {"shadows=volumes,depth-slices=1", "volumes"},
        {"shadows=volumes,flat-tolerance=1", "coarser casters"},
        {"shadows=primitive-map", "primitive map"},
        {"shadows=none", "no shadows"},
        {"shadows=map,map-size=512", "maps"},
        {"shadows=map,map-size=512,pcf=3", "maps, pcf"},
        {"shadows=map,pcf=1,map-size=512", "maps"},
        {"shadows=map,filter=vsm,pcf=5", "maps, vsm"},
        {"shadows=map,filter=none", "maps"},
        {"shadows=map,map-kind=cascades,filter=vsm", "cascades"},
        {"shadows=irregular-z-buffer", "irregular z buffer"}};
    for (const auto& [text, family] : cases)
        EXPECT_EQ(familyOf(settingsFrom(DrawSettings(), text)), family) << text;
}

TEST(TradeoffFamily, NewFamiliesMoveNoneOfTheOthers) {
    const auto before = allFamilies({}),
               after = allFamilies({"maps", "ray cast", "maps, new", "ray cast"});
    ASSERT_EQ(after.size(), before.size() + 2);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
    EXPECT_EQ(after[before.size()], "ray cast");
    EXPECT_EQ(after.back(), "maps, new");
}

TEST(TradeSettings, ManyLampsAddShadowsForSomeOfThem) {
    const std::vector<Light> lamps(8, {.position = {0.0, 2.0, 0.0, 1.0}});
    std::set<std::string> names;
    for (const TradeSetting& setting : tradeSettings(512, 10.0, lamps))
        names.insert(setting.name);
    for (const char* name : {"1 shadowed light", "4 shadowed lights", "paraboloid 512"})
        EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_FALSE(names.contains("cascades 4 x 512")) << "no light is a sun";
    EXPECT_FALSE(names.contains("map 1024"));
}

} // namespace
} // namespace edgeshade::cli
