// Interrupting the program, and running it twice at once.
#include "preprocess/gltf/gltf_reading.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

namespace edgeshade::test {
namespace {

const std::string pavilion = std::string(EDGESHADE_ASSETS) + "/pavilion.glb";

/// Interrupts the program after several delays: it ends by the signal or has finished already, and
/// its output is complete or missing.
template <class IsWhole>
void interruptAtSeveralDelays(int signal, const std::vector<std::string>& arguments, int longest,
                              IsWhole isWhole) {
    for (int delay = 0; delay <= longest; delay += std::max(1, longest / 16)) {
        SCOPED_TRACE("after " + std::to_string(delay) + " ms");
        const TempFolder folder;
        const std::string output = folder / "output";
        std::vector<std::string> all = arguments;
        all.insert(all.begin() + 2, output);
        ChildProcess process(EDGESHADE_PROGRAM, all);
        std::this_thread::sleep_for(std::chrono::milliseconds(delay));
        process.send(signal);
        const ProcessResult result = process.wait();
        EXPECT_TRUE(result.status == 0 || result.signal == signal) << result.status;
        EXPECT_EQ(folder.partialFiles(), 0u);
        const bool exists = std::filesystem::exists(output);
        EXPECT_TRUE(!exists || isWhole(output));
        EXPECT_TRUE(result.status != 0 || exists);
    }
}

bool isWholeGlb(const std::string& path) {
    return readGltf(path).json["extensionsUsed"].back() == "EDGESHADE_shadow_volume";
}

bool isWholePng(const std::string& path) {
    const Bytes bytes = readFile(path);
    return bytes.size() > 12 && bytes[bytes.size() - 8] == 'I' && bytes[bytes.size() - 7] == 'E';
}

} // namespace

TEST(Interrupted, PackLeavesNoPartialFile) {
    for (const int signal : {SIGINT, SIGTERM})
        interruptAtSeveralDelays(signal, {"pack", pavilion, "--encoding", "expanded"}, 64,
                                 isWholeGlb);
}

TEST(Interrupted, RenderLeavesNoPartialFile) {
    interruptAtSeveralDelays(SIGINT, {"render", pavilion, "--size", "320x180"}, 480, isWholePng);
}

TEST(Interrupted, BenchLeavesNoPartialReport) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const TempFolder folder;
        const std::string report = folder / "report.json";
        ChildProcess process(EDGESHADE_PROGRAM, {"bench", pavilion, "--size", "320x180", "--frames",
                                                 "100000", "--report", report});
        std::this_thread::sleep_for(std::chrono::milliseconds(1500));
        process.send(signal);
        EXPECT_EQ(process.wait().signal, signal);
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST(Concurrent, PacksToOneOutputLeaveAWholeFile) {
    const TempFolder folder;
    const std::string output = folder / "packed.glb";
    for (int round = 0; round < 5; ++round) {
        std::vector<std::unique_ptr<ChildProcess>> processes;
        for (const char* encoding : {"expanded", "indexed", "none", "expanded"})
            processes.push_back(std::make_unique<ChildProcess>(
                EDGESHADE_PROGRAM,
                std::vector<std::string>{"pack", pavilion, output, "--encoding", encoding}));
        for (const auto& process : processes)
            EXPECT_EQ(process->wait().status, 0);
        EXPECT_TRUE(isWholeGlb(output));
        EXPECT_EQ(folder.names(), std::vector<std::string>{"packed.glb"});
    }
}

} // namespace edgeshade::test
