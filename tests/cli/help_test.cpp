#include "tests/support/child_process.hpp"

#include <gtest/gtest.h>

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
    for (const char* word : {"pack", "info", "render", "compare", "bench", "tradeoff", "sunhours",
                             "sunhours-merge", "view", "Exit status"})
        expectHelp({"--help"}, word);
}

TEST(Help, EveryVerbNamesItsOptions) {
    for (const char* word : {"OUT", "--encoding", "--weld-tolerance", "--flat-tolerance",
                             "--caster-error", "--cast-masked", "--report"})
        expectHelp({"pack", "--help"}, word);
    for (const char* word : {"FILE", "--weld-tolerance", "--report"})
        expectHelp({"info", "--help"}, word);
    for (const char* word : {"OUT",           "--mask",
                             "--size",        "--camera",
                             "--camera-from", "--camera-to",
                             "--fov",         "--camera-matrix",
                             "--ortho",       "--near",
                             "--light",       "--sun",
                             "--lights",      "--light-range",
                             "--shadows",     "--map-size",
                             "--map-bias",    "--map-kind",
                             "--warp",        "--cascades",
                             "--filter",      "--pcf",
                             "--mask-scale",  "--multiplicity",
                             "--instancing",  "--depth-slices",
                             "--samples",     "--report",
                             "--silhouette",  "--explain",
                             "--debug",       "--primitive-map-memory",
                             "--ground",      "--cast-cutouts",
                             "--cull",        "--place",
                             "--time-of-day", "--north",
                             "--volume-ends", "--caster-culling",
                             "--cull-solids", "--volume-scissors",
                             "--terminator",  "--ambient-target"})
        expectHelp({"render", "--help"}, word);
    for (const char* word : {"FILE", "--views", "--heatmap", "--against", "--size", "--report"})
        expectHelp({"compare", "--help"}, word);
    for (const char* word :
         {"FILE", "--frames", "--warm-up", "--sizes", "--against", "--light-moves",
          "--light-circle", "--timing", "--synthetic", "--shadows", "--report"})
        expectHelp({"bench", "--help"}, word);
    for (const char* word : {"FILE", "--plot", "--budget-ms", "--max-wrong-percent", "--frames",
                             "--views", "--largest-map", "--against", "--light-moves", "--timing"})
        expectHelp({"tradeoff", "--help"}, word);
}

TEST(Help, TheVersionIsOneLine) {
    const ProcessResult result = runEdgeshade({"--version"});
    EXPECT_EQ(result.status, 0);
    EXPECT_TRUE(result.out.starts_with("edgeshade ")) << result.out;
    EXPECT_EQ(result.out.find('\n'), result.out.size() - 1);
    EXPECT_EQ(result.err, "");
}

} // namespace edgeshade::test
