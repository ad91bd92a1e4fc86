// The program under valgrind: it reads and writes only its own memory, no undefined value decides
// anything, nothing leaks. valgrind.supp lists the exceptions with reasons.
#include "tests/support/child_process.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/temp_folder.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade::test {
namespace {

/// valgrind's exit status if it has found something.
constexpr int found = 99;

/// valgrind's path; empty if it is not installed.
std::string valgrind() {
    for (const char* path : {"/usr/bin/valgrind", "/usr/local/bin/valgrind"})
        if (std::filesystem::exists(path)) return path;
    return "";
}

class Valgrind : public testing::Test {
  protected:
    void SetUp() override {
        if (valgrind().empty()) GTEST_SKIP() << "valgrind is not installed";
#ifdef __SANITIZE_ADDRESS__
        GTEST_SKIP() << "valgrind can't run what the address sanitizer watches";
#endif
        varied_ = folder_.write("varied.glb", variedScene().glb());
    }

    void expectClean(const std::vector<std::string>& arguments) const {
        std::vector<std::string> all = {"--quiet",
                                        "--error-exitcode=" + std::to_string(found),
                                        "--leak-check=full",
                                        "--show-leak-kinds=definite",
                                        "--errors-for-leak-kinds=definite",
                                        "--keep-debuginfo=yes", // Mesa's driver gets unloaded
                                        "--suppressions=" EDGESHADE_SUPPRESSIONS,
                                        EDGESHADE_PROGRAM};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const ProcessResult result = ChildProcess(valgrind(), all).wait(1800.0);
        EXPECT_EQ(result.status, 0) << result.err;
        std::cout << "[ valgrind ] " << arguments[0] << " "
                  << std::filesystem::path(arguments[1]).filename().string() << ": "
                  << (result.status == 0 ? "clean" : "not clean") << ", " << result.seconds
                  << " s\n";
    }

    const std::string pavilion_ = std::string(EDGESHADE_ASSETS) + "/pavilion.glb";
    std::string varied_;
    TempFolder folder_;
};

TEST_F(Valgrind, PackIsClean) {
    for (const std::string& scene : {pavilion_, varied_})
        for (const char* encoding : {"none", "expanded"})
            expectClean({"pack", scene, folder_ / "out.glb", "--encoding", encoding});
}

TEST_F(Valgrind, RenderIsClean) {
    for (const std::string& scene : {pavilion_, varied_})
        expectClean({"render", scene, folder_ / "out.png", "--size", "64x36", "--light", "2,3,2"});
}

} // namespace
} // namespace edgeshade::test
