#include "src/hours/preset.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {

TEST(Presets, HaveTheHoursThatArePublished) {
    ASSERT_EQ(presets().size(), 6u);
    EXPECT_EQ(findPreset("en17037-minimum")->threshold, 1.5);
    EXPECT_EQ(findPreset("en17037-medium")->threshold, 3.0);
    EXPECT_EQ(findPreset("en17037-high")->threshold, 4.0);
    EXPECT_EQ(findPreset("bre-garden")->threshold, 2.0);
    using namespace std::chrono;
    for (const Preset& preset : presets()) {
        EXPECT_EQ(preset.ofHalfTheArea, preset.name == "bre-garden");
        EXPECT_EQ(preset.minAltitude, preset.name.starts_with("din5034") ? 6.0 : 0.0);
        EXPECT_TRUE(preset.name == "din5034-winter" || preset.last == March / 21) << preset.name;
    }
    EXPECT_EQ(findPreset("en17037-high")->first, February / 1);
    EXPECT_EQ(findPreset("bre-garden")->first, March / 21);
    EXPECT_EQ(findPreset("din5034-winter")->threshold, 1.0);
    EXPECT_EQ(findPreset("din5034-winter")->first, January / 17);
    EXPECT_EQ(findPreset("din5034-winter")->last, January / 17);
    EXPECT_EQ(findPreset("din5034-equinox")->threshold, 4.0);
    EXPECT_EQ(findPreset("en17037"), nullptr);
}

TEST(Presets, PutThePointOfEn17037OverSillAndFloor) {
    const Preset& minimum = *findPreset("en17037-minimum");
    EXPECT_EQ(minimum.riseInWindow({}), 0.3);
    EXPECT_EQ(minimum.riseInWindow(0.0), 1.2);
    EXPECT_DOUBLE_EQ(*minimum.riseInWindow(0.7), 0.5);
    EXPECT_EQ(minimum.riseInWindow(0.95), 0.3);
    EXPECT_FALSE(findPreset("din5034-winter")->riseInWindow(0.7));
}

} // namespace edgeshade::hours
