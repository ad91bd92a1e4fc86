// Outputs that can't be written: status 4, one sentence that names the file, nothing half written.
#include "tests/cli/message.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <array>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace edgeshade::test {
namespace {

/// A folder with a sound scene, and the writing verbs.
class BadOutput : public testing::TestWithParam<std::string> {
  protected:
    BadOutput() {
        GltfBuilder gltf;
        gltf.addShapeNode(tetrahedron());
        input_ = folder_.write("in.glb", gltf.glb());
    }

    ProcessResult run(const std::string& output, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {GetParam(), input_, output};
        if (GetParam() == "render") arguments.insert(arguments.end(), {"--size", "16x16"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runEdgeshade(arguments);
    }

    void expectCantWrite(const std::string& output, const std::string& word) const {
        const ProcessResult result = run(output);
        EXPECT_EQ(result.status, 4);
        expectOneSentence(result);
        EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
        EXPECT_EQ(folder_.partialFiles(), 0u);
    }

    TempFolder folder_;
    std::string input_;
};

} // namespace

TEST_P(BadOutput, AMissingFolderIsNamed) {
    expectCantWrite(folder_ / "gone/out", "gone/out");
}

TEST_P(BadOutput, AFolderIsNoFile) {
    std::filesystem::create_directory(folder_ / "folder");
    expectCantWrite(folder_ / "folder", "is a folder");
}

TEST_P(BadOutput, AFileIsNoFolder) {
    expectCantWrite(input_ + "/out", "in.glb/out");
}

TEST_P(BadOutput, AnEmptyNameIsNoFile) {
    const ProcessResult result = run("");
    EXPECT_TRUE(result.status == 1 || result.status == 4) << result.status;
    EXPECT_NE(result.err, "");
}

TEST_P(BadOutput, ANameThatIsTooLongIsNamed) {
    expectCantWrite(folder_ / std::string(300, 'x'), "xxx");
}

TEST_P(BadOutput, ANameOfTheGreatestLengthCanBeWritten) {
    const std::string output = folder_ / std::string(255, 'x');
    EXPECT_EQ(run(output).status, 0);
    EXPECT_TRUE(std::filesystem::exists(output));
}

TEST_P(BadOutput, AReadOnlyFolderIsNamed) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    std::filesystem::create_directory(folder_ / "locked");
    std::filesystem::permissions(folder_ / "locked", std::filesystem::perms::owner_read |
                                                         std::filesystem::perms::owner_exec);
    expectCantWrite(folder_ / "locked/out", "locked/out");
}

TEST_P(BadOutput, AFullDeviceIsNamed) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    // Through a link: a program that replaces its output instead of writing into it replaces only
    // the link.
    std::filesystem::create_symlink("/dev/full", folder_ / "full");
    expectCantWrite(folder_ / "full", "full");
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "full"));
}

TEST_P(BadOutput, ALinkIsWrittenThrough) {
    std::filesystem::create_symlink("target", folder_ / "link");
    EXPECT_EQ(run(folder_ / "link").status, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "target"));
}

TEST_P(BadOutput, APipeIsWrittenIntoAndStaysAPipe) {
    const std::string pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR), 0);
    const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader, 0);
    const ProcessResult result = run(pipe);
    std::array<char, 16> start{};
    const ssize_t size = ::read(reader, start.data(), start.size());
    ::close(reader);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_GT(size, 0);
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST_P(BadOutput, AnOldFileStaysWhereWritingFails) {
    std::filesystem::create_directory(folder_ / "report");
    folder_.write("out", std::string_view("old"));
    const ProcessResult result = run("/proc/out");
    EXPECT_EQ(result.status, 4);
    EXPECT_EQ(readFile(folder_ / "out"), (Bytes{'o', 'l', 'd'}));
}

TEST_P(BadOutput, AReportThatCantBeWrittenIsNamed) {
    const ProcessResult result = run(folder_ / "out", {"--report", folder_ / "gone/report.json"});
    EXPECT_EQ(result.status, 4);
    expectOneSentence(result);
    EXPECT_NE(result.err.find("gone/report.json"), std::string::npos);
    EXPECT_EQ(folder_.partialFiles(), 0u);
}

TEST_P(BadOutput, ANewFileMayBeReadAsTheUserSays) {
    const mode_t before = ::umask(S_IRWXO);
    EXPECT_EQ(run(folder_ / "out").status, 0);
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat((folder_ / "out").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

INSTANTIATE_TEST_SUITE_P(Verbs, BadOutput, testing::Values("pack", "render"),
                         [](const auto& verb) { return verb.param; });

TEST(Output, TheInputMayBeReplacedByItsPackedSelf) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const std::string scene = folder.write("scene.glb", gltf.glb());
    EXPECT_EQ(runEdgeshade({"pack", scene, scene}).status, 0);
    EXPECT_NE(runEdgeshade({"info", scene}).out.find("yes"), std::string::npos);
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(Output, AClosedStandardOutputIsNoSuccess) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const std::string scene = folder.write("scene.glb", gltf.glb());
    const std::string command =
        "exec '" + std::string(EDGESHADE_PROGRAM) + "' info '" + scene + "' --report - > /dev/full";
    const ProcessResult result = ChildProcess("/bin/sh", {"-c", command}).wait();
    EXPECT_EQ(result.status, 4) << result.err;
}

} // namespace edgeshade::test
