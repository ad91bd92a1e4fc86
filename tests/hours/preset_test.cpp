#include "src/hours/preset.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {

TEST(Presets, HaveTheHoursThatArePublished) {
    ASSERT_EQ(presets().size(), 4u);
    EXPECT_EQ(findPreset("en17037-minimum")->threshold, 1.5);
    EXPECT_EQ(findPreset("en17037-medium")->threshold, 3.0);
    EXPECT_EQ(findPreset("en17037-high")->threshold, 4.0);
    EXPECT_EQ(findPreset("bre-garden")->threshold, 2.0);
    using namespace std::chrono;
    for (const Preset& preset : presets()) {
        EXPECT_EQ(preset.ofHalfTheArea, preset.name == "bre-garden");
        EXPECT_EQ(preset.last, March / 21);
        EXPECT_EQ(preset.first, preset.ofHalfTheArea ? March / 21 : February / 1);
    }
    EXPECT_EQ(findPreset("en17037"), nullptr);
}

} // namespace edgeshade::hours
