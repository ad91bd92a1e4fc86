#include "edgeshade/version.hpp"
#include "tests/support/run_edgeshade.hpp"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace edgeshade::test {
namespace {

void expectHelp(const std::vector<std::string>& arguments, const std::string& word) {
    const ProcessResult result = runEdgeshade(arguments);
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find(word), std::string::npos) << result.out;
}

} // namespace

TEST(Help, TheProgramNamesItsVerbsAndStatuses) {
    for (const char* word :
         {"pack", "info", "render", "compare", "bench", "tradeoff", "sunhours", "sunhours-merge",
          "city-plan", "city-run", "city-merge", "view", "Exit status"})
        expectHelp({"--help"}, word);
}

constexpr std::array verbs{"pack",      "info",     "render",     "compare",
                           "bench",     "tradeoff", "sunhours",   "sunhours-merge",
                           "city-plan", "city-run", "city-merge", "view"};

TEST(Help, FitsAScreen) {
    for (const char* verb : verbs) {
        const std::string help = runEdgeshade({verb, "--help"}).out;
        EXPECT_LE(std::ranges::count(help, '\n'), 30) << help;
        std::istringstream lines(help);
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 100u) << line;
        expectHelp({verb, "--help"}, "Example: edgeshade " + std::string(verb));
        expectHelp({verb, "--help"}, "--help-all");
    }
}

/// The long names of a help text's options, in their order.
std::vector<std::string> optionsIn(const std::string& help) {
    std::vector<std::string> options;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find("--");
        if (!line.starts_with("  ") || start == std::string::npos || start > 6) continue;
        options.push_back(line.substr(start, line.find_first_of(" :", start) - start));
    }
    return options;
}

TEST(Help, OfAllHasWhatTheShortOneHas) {
    for (const char* verb : verbs) {
        const std::vector<std::string> all = optionsIn(runEdgeshade({verb, "--help-all"}).out);
        const std::set<std::string> once(all.begin(), all.end());
        EXPECT_EQ(once.size(), all.size()) << verb;
        for (const std::string& option : optionsIn(runEdgeshade({verb, "--help"}).out))
            EXPECT_TRUE(once.contains(option)) << verb << " " << option;
    }
}

TEST(Help, OfAllEndsWithTheLaboratory) {
    const std::string help = runEdgeshade({"render", "--help-all"}).out;
    const std::size_t laboratory = help.find("Laboratory");
    ASSERT_NE(laboratory, std::string::npos);
    for (const char* option : {"--layout", "--multiplicity", "--silhouette", "--planes"})
        EXPECT_GT(help.find("\n  " + std::string(option)), laboratory) << option;
    for (const char* option : {"--sun", "--shadows", "--max-file"})
        EXPECT_LT(help.find("\n  " + std::string(option)), laboratory) << option;
}

TEST(Help, TheVersionIsOneLine) {
    const ProcessResult result = runEdgeshade({"--version"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, "edgeshade " + std::string(versionText) + "\n");
    EXPECT_EQ(versionText, std::to_string(EDGESHADE_VERSION_MAJOR) + "." +
                               std::to_string(EDGESHADE_VERSION_MINOR) + "." +
                               std::to_string(EDGESHADE_VERSION_PATCH));
    EXPECT_EQ(result.err, "");
}

} // namespace edgeshade::test
