// Every option is in the table once for each of its verbs, and the program takes what it says.

#include "src/cli/add_options.hpp"
#include "src/cli/draw_settings.hpp"
#include "tests/support/run_edgeshade.hpp"

#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace edgeshade::test {
namespace {

using cli::Option;

template <class Use>
void forEachOption(Use use) {
    for (const cli::OptionGroup& group : cli::optionTable())
        for (const Option& option : group.options)
            use(option);
}

/// The names of options in a help text.
std::set<std::string> optionsIn(const std::string& help) {
    std::set<std::string> options;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find("--");
        if (line.starts_with("  ") && start <= 5)
            options.insert(line.substr(start, line.find(' ', start) - start));
    }
    return options;
}

} // namespace

TEST(OptionTable, EachVerbHasAnOptionOnce) {
    for (const std::string_view verb : cli::verbNames) {
        std::set<std::string> names;
        forEachOption([&](const Option& option) {
            const bool isOfVerb = option.where.verbs & cli::verbOf(verb);
            EXPECT_TRUE(!isOfVerb || names.insert(option.name).second) << verb << option.name;
        });
    }
}

TEST(OptionTable, EachOptionHasVerbsAndASentence) {
    forEachOption([](const Option& option) {
        EXPECT_NE(option.where.verbs, 0u) << option.name;
        EXPECT_EQ(option.where.brief & ~option.where.verbs, 0u) << option.name;
        EXPECT_FALSE(option.sentence.empty()) << option.name;
        EXPECT_FALSE(option.sentence.ends_with('.')) << option.name;
        EXPECT_TRUE(option.more.empty() || option.more.ends_with('.')) << option.name;
    });
}

TEST(OptionTable, DefaultsAreValues) {
    forEachOption([](const Option& option) {
        SCOPED_TRACE(option.name);
        const std::string text = option.defaultText();
        if (!option.setsDefault()) return;
        if (option.values.interval) {
            EXPECT_NO_THROW(numberIn(option.values, option.name, text));
        } else if (!option.values.words.empty()) {
            EXPECT_NO_THROW(wordIn(option.values, option.name, text));
        }
    });
}

TEST(OptionTable, HelpOfEachVerbListsItsOptionsAndNoOthers) {
    for (const std::string_view verb : cli::verbNames) {
        const std::string help = runEdgeshade({std::string(verb), "--help-all"}).out;
        if (help.find("not built in") != std::string::npos) continue;
        std::set<std::string> expected;
        forEachOption([&](const Option& option) {
            if (option.where.verbs & cli::verbOf(verb)) expected.insert(option.name);
        });
        EXPECT_EQ(optionsIn(help), expected) << verb;
        EXPECT_EQ(help.find("Not in the table"), std::string::npos) << help;
    }
}

TEST(OptionTable, DefaultsOfDrawingAreThoseOfTheLibrary) {
    CLI::App program;
    cli::DrawSettings typed, plain;
    addDrawOptions(*program.add_subcommand("render"), typed);
    resolve(typed);
    resolve(plain);
    EXPECT_EQ(settingsJson(typed), settingsJson(plain));
}

TEST(OptionTable, DefaultsOfLimitsAreThoseOfTheLibrary) {
    CLI::App program;
    const ReadingLimits plain;
    ReadingLimits typed{1, 1, 1, 1, 1};
    cli::addLimitOptions(*program.add_subcommand("info"), typed);
    EXPECT_EQ(typed.fileBytes, plain.fileBytes);
    EXPECT_EQ(typed.memoryBytes, plain.memoryBytes);
    EXPECT_EQ(typed.triangles, plain.triangles);
    EXPECT_EQ(typed.nodes, plain.nodes);
    EXPECT_EQ(typed.nodeDepth, plain.nodeDepth);
}

TEST(OptionTable, WhatIsOutsideAnIntervalIsRefused) {
    using cli::Interval;
    using cli::numberIn;
    const auto sentenceOf = [](const Interval& interval, const std::string& text) -> std::string {
        try {
            numberIn({{}, interval}, "--option", text);
        } catch (const CLI::ValidationError& error) {
            return error.what();
        }
        return "";
    };
    const Interval closed{.low = 0.0, .high = 4.0};
    const Interval open{.low = 0.0, .high = 4.0, .isAbove = true, .isBelow = true};
    const Interval whole{.low = 0.0, .high = 4.0, .isWhole = true};
    EXPECT_EQ(sentenceOf(closed, "0"), "");
    EXPECT_EQ(sentenceOf(closed, "4"), "");
    EXPECT_EQ(sentenceOf(closed, "-1e-300"), "--option: '-1e-300' is below 0");
    EXPECT_EQ(sentenceOf(closed, "4.01"), "--option: '4.01' is above 4");
    EXPECT_EQ(sentenceOf(open, "1e-300"), "");
    EXPECT_EQ(sentenceOf(open, "0"), "--option: '0' is not above 0");
    EXPECT_EQ(sentenceOf(open, "4"), "--option: '4' is not below 4");
    EXPECT_EQ(sentenceOf(whole, "3"), "");
    EXPECT_EQ(sentenceOf(whole, "3.5"), "--option: '3.5' is no whole number");
    for (const char* text : {"nan", "inf", "1e999", "", "1 ", "0x1", "three"})
        EXPECT_NE(sentenceOf(closed, text), "") << text;
    EXPECT_EQ(numberIn({{"auto"}, open}, "--option", "auto"), std::nullopt);
}

} // namespace edgeshade::test
