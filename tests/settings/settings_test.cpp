// Every setting, read and written at its extremes by the command line and by a view's state.

#include "preprocess/base/error.hpp"
#include "src/cli/draw_settings.hpp"
#include "src/viewer/view_state.hpp"

#include <gtest/gtest.h>
#include <set>

namespace edgeshade::test {
namespace {

using Json = nlohmann::ordered_json;
using cli::forEachSetting;

/// Texts of extreme values, and of values beyond them.
struct Extremes {
    std::vector<std::string> inside, outside;
};

template <class Value, std::size_t N>
Extremes extremesOf(const Words<Value, N>& words) {
    Extremes extremes{{}, {"", "none of them", "AUTO"}};
    for (const Word<Value>& word : words)
        extremes.inside.push_back(word.text);
    return extremes;
}
template <std::size_t N>
Extremes extremesOf(const Numbers<N>& numbers) {
    Extremes extremes{{}, {"0", "2", "3.5", "-1"}};
    for (const int number : numbers.all)
        extremes.inside.push_back(std::to_string(number));
    return extremes;
}
Extremes extremesOf(const WholeRange& range) {
    return {{std::to_string(range.low), std::to_string(range.high)},
            {std::to_string(range.low - 1), std::to_string(range.high + 1),
             std::to_string(range.low) + ".5", "nan", "inf", "1e999", "-1e999", "?"}};
}
Extremes extremesOf(const NumberRange& range) {
    const Json low = range.low, high = range.high;
    return {{low.dump(), high.dump(), Json(0.5 * (range.low + range.high)).dump()},
            {Json(range.low - 1.0).dump(), Json(range.high + 0.001).dump(), "nan", "inf", "1e999",
             "?"}};
}
template <class Domain>
Extremes extremesOf(const Optional<Domain>& optional) {
    Extremes extremes = extremesOf(optional.domain);
    extremes.inside.push_back(optional.none);
    return extremes;
}
Extremes extremesOf(const FileName& file) {
    return {{file.none}, {"no such file.hdr"}};
}

/// `--against` for what the condition needs.
std::string settingsFor(Condition condition) {
    switch (condition) {
    case Condition::bruteForce:
        return "layout=brute-force,";
    case Condition::planar:
        return "shadows=planar,";
    case Condition::volumes:
        return "shadows=volumes,";
    case Condition::lookups:
        return "shadows=auto,";
    case Condition::map:
        return "shadows=map,";
    case Condition::cascades:
        return "shadows=map,map-kind=cascades,";
    case Condition::warped:
        return "shadows=map,map-kind=warped,";
    default:
        return "";
    }
}

std::string textOf(const Json& json) {
    return json.is_string() ? json.get<std::string>() : json.dump();
}

cli::DrawSettings settingsOf(const std::string& text) {
    return settingsFrom(cli::DrawSettings(), text);
}

/// A member of a view's state as it is read, and as it is written.
struct Member {
    Json read, written;
};

template <class Domain>
std::vector<Member> membersOf(const Domain& domain) {
    std::vector<Member> members;
    for (const std::string& text : extremesOf(domain).inside)
        members.push_back({Json::parse(text), Json::parse(text)});
    return members;
}
template <class Value, std::size_t N>
std::vector<Member> membersOf(const Words<Value, N>& words) {
    std::vector<Member> members;
    for (const Word<Value>& word : words)
        members.push_back({word.text, wordOf(words, word.value)});
    return members;
}
template <std::size_t N>
std::vector<Member> membersOf(const Words<int, N>& words) {
    std::vector<Member> members;
    for (const Word<int>& word : words)
        members.push_back({word.value, word.value});
    return members;
}

} // namespace

TEST(Settings, KeysAreUnique) {
    std::set<std::string> keys, sideKeys;
    forEachSetting(
        [&](const auto& setting) { EXPECT_TRUE(keys.insert(setting.key).second) << setting.key; });
    forEachSideSetting([&](const auto& setting) {
        EXPECT_TRUE(sideKeys.insert(setting.key).second) << setting.key;
        EXPECT_TRUE(keys.count(setting.key)) << setting.key;
    });
}

TEST(Settings, TheCommandLineReadsWhatReportsWrite) {
    forEachSetting([](const auto& setting) {
        const std::string name = cli::optionNameOf(setting.key).substr(2);
        for (const std::string& text : extremesOf(setting.domain).inside) {
            const std::string typed = settingsFor(setting.needs) + name + "=" + text;
            SCOPED_TRACE(typed);
            const Json json = settingsJson(settingsOf(typed));
            ASSERT_TRUE(json.contains(name)) << json;
            const std::string again = settingsFor(setting.needs) + name + "=" + textOf(json[name]);
            EXPECT_EQ(settingsJson(settingsOf(again)), json);
        }
    });
}

TEST(Settings, TheCommandLineRefusesWhatIsBeyond) {
    forEachSetting([](const auto& setting) {
        const std::string name = cli::optionNameOf(setting.key).substr(2);
        for (const std::string& text : extremesOf(setting.domain).outside) {
            const std::string typed = settingsFor(setting.needs) + name + "=" + text;
            EXPECT_THROW(settingsOf(typed), std::runtime_error) << typed;
        }
    });
}

TEST(Settings, AnOptionWithoutEffectIsRefused) {
    forEachSetting([](const auto& setting) {
        if (setting.needs == Condition::none) return;
        const std::string option = cli::optionNameOf(setting.key);
        const std::string text = extremesOf(setting.domain).inside.front();
        try {
            settingsOf("shadows=none,shading=base," + option.substr(2) + "=" + text);
            ADD_FAILURE() << option << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find(option + " needs --"), 0u) << error.what();
        }
    });
}

TEST(Settings, ReportsLeaveOutSettingsWithoutEffect) {
    const Json json = settingsJson(settingsOf("shadows=none,shading=base"));
    forEachSetting([&](const auto& setting) {
        EXPECT_EQ(json.contains(cli::optionNameOf(setting.key).substr(2)),
                  setting.needs == Condition::none)
            << setting.key;
    });
}

TEST(Settings, OnTopOfOthersOneChangesNoOther) {
    const cli::DrawSettings base = settingsOf("shadows=map,filter=pcf,pcf=5,ambient=0.25");
    Json expected = settingsJson(base);
    expected["map-size"] = 512;
    EXPECT_EQ(settingsJson(settingsFrom(base, "map-size=512")), expected);
}

TEST(Settings, AStateReadsWhatItWrites) {
    forEachSideSetting([](const auto& setting) {
        for (const Member& member : membersOf(setting.domain)) {
            SCOPED_TRACE(setting.key + (": " + member.read.dump()));
            const Json changes = {{"right", {{setting.key, member.read}}}};
            const Json right = toJson(changed(viewer::ViewState(), changes))["right"];
            EXPECT_EQ(right[setting.key], member.written);
            EXPECT_EQ(toJson(changed(viewer::ViewState(), {{"right", right}}))["right"], right);
        }
    });
}

TEST(Settings, AStateRefusesWhatIsBeyond) {
    forEachSideSetting([](const auto& setting) {
        for (const Json& value : {Json("none of them"), Json(-1), Json(1e9), Json(2.5), Json(NAN),
                                  Json(nullptr), Json::array(), Json(true)}) {
            const Json changes = {{"left", {{setting.key, value}}}};
            EXPECT_THROW(changed(viewer::ViewState(), changes), Error) << changes;
        }
    });
}

} // namespace edgeshade::test
