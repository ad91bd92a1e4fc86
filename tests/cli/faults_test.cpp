// Faults from outside: a full disk, a read-only folder, signals, too little memory, two programs at
// once. The output is the old file or the new one, and nothing else is left beside it.
#include "preprocess/gltf/gltf_reading.hpp"
#include "tests/cli/documented.hpp"
#include "tests/cli/message.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <chrono>
#include <csignal>
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <thread>
#include <unistd.h>

namespace edgeshade::test {
namespace {

const std::string program = EDGESHADE_PROGRAM;
const std::string pavilion = std::string(EDGESHADE_ASSETS) + "/pavilion.glb";
const std::string oldContent = "what was there before";

/// A row of the table of faults: how it is caused and checked, and its text in the table.
struct Fault {
    std::string name; ///< an identifier, as GoogleTest requires
    std::string what;
    std::string ends; ///< "status 4", "signal", ...
    std::function<void()> check;
    friend void PrintTo(const Fault& row, std::ostream* stream) { *stream << row.name; }
};

/// Runs a shell command line, in which $IN is a scene, $OUT a file with old content in an otherwise
/// empty folder, and $EDGESHADE the program.
ProcessResult shell(const TempFolder& folder, const std::string& line) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    const std::string in = folder.write("in/scene.glb", gltf.glb());
    const std::string out = folder.write("out/file", std::string_view(oldContent));
    return ChildProcess("/bin/sh", {"-c", line},
                        {{"EDGESHADE", program}, {"PAVILION", pavilion}, {"IN", in}, {"OUT", out}})
        .wait(60.0);
}

std::string contentOf(const std::filesystem::path& path) {
    const Bytes bytes = readFile(path);
    return {bytes.begin(), bytes.end()};
}

void expectOldFileAlone(const TempFolder& folder) {
    EXPECT_EQ(contentOf(folder / "out/file"), oldContent);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 1);
}

/// Expects that the command ends with this status and one sentence, and that the old file stays.
Fault refusal(const std::string& name, const std::string& what, int status, const std::string& line,
              const std::string& word) {
    return {name, what, "status " + std::to_string(status), [=] {
                const TempFolder folder;
                const ProcessResult result = shell(folder, line);
                EXPECT_EQ(result.status, status) << result.err;
                EXPECT_EQ(result.signal, 0);
                expectOneSentence(result);
                EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
                expectOldFileAlone(folder);
            }};
}

bool isPacked(const std::filesystem::path& path) {
    return readGltf(path).json["extensionsUsed"].back() == "EDGESHADE_shadow_volume";
}

bool isPng(const std::filesystem::path& path) {
    const std::string bytes = contentOf(path);
    return bytes.size() > 12 && bytes.substr(bytes.size() - 8, 4) == "IEND";
}

using IsWhole = std::function<bool(const std::filesystem::path&)>;

/// Signals at random moments of many runs: the file is the old or a complete new one.
Fault interruption(const std::string& name, const std::string& what, int signal,
                   const std::vector<std::string>& before, const std::vector<std::string>& after,
                   int longestMs, const IsWhole& isWhole) {
    return {name, what, signal == SIGKILL ? "signal; a .part file may stay" : "signal", [=] {
                constexpr int runs = 30;
                std::minstd_rand random(static_cast<unsigned>(signal));
                for (int run = 0; run < runs; ++run) {
                    const int delay = std::uniform_int_distribution(0, longestMs)(random);
                    SCOPED_TRACE("after " + std::to_string(delay) + " ms");
                    const TempFolder folder;
                    const auto output = folder.write("file", std::string_view(oldContent));
                    std::vector<std::string> arguments = before;
                    arguments.push_back(output);
                    arguments.insert(arguments.end(), after.begin(), after.end());
                    ChildProcess process(program, arguments);
                    std::this_thread::sleep_for(std::chrono::milliseconds(delay));
                    process.send(signal);
                    const ProcessResult result = process.wait(60.0);
                    EXPECT_TRUE(result.status == 0 || result.signal == signal) << result.status;
                    const bool isOld = contentOf(output) == oldContent;
                    EXPECT_TRUE(isOld || isWhole(output));
                    EXPECT_TRUE(result.status != 0 || !isOld);
                    EXPECT_TRUE(signal == SIGKILL || folder.names().size() == 1);
                }
            }};
}

/// Several programs that write one output at once; those whose `kill` is set are killed meanwhile.
void packAtOnce(const std::vector<std::pair<std::string, bool>>& encodings) {
    const TempFolder folder;
    const auto output = folder.write("file", std::string_view(oldContent));
    std::vector<std::unique_ptr<ChildProcess>> processes;
    for (const auto& [encoding, kill] : encodings)
        processes.push_back(std::make_unique<ChildProcess>(
            program, std::vector<std::string>{"pack", pavilion, output, "--encoding", encoding}));
    std::this_thread::sleep_for(std::chrono::milliseconds(40));
    for (std::size_t i = 0; i < encodings.size(); ++i)
        if (encodings[i].second) processes[i]->send(SIGTERM);
    for (std::size_t i = 0; i < encodings.size(); ++i) {
        const ProcessResult result = processes[i]->wait(60.0);
        EXPECT_TRUE(result.status == 0 || (encodings[i].second && result.signal == SIGTERM));
    }
    EXPECT_TRUE(isPacked(output));
    EXPECT_EQ(folder.names().size(), 1u);
}

/// A disk that is really full: a small one in memory, visible only to the program.
void fillADisk() {
    const TempFolder folder;
    const ProcessResult result = shell(folder, R"(unshare -rm sh -c '
                  mount -t tmpfs -o size=64k none "${OUT%/*}" || { echo unable; exit; }
                  head -c 40000 /dev/zero > "$OUT"
                  "$EDGESHADE" pack "$PAVILION" "$OUT" --encoding expanded
                  echo "status $?, $(ls -A "${OUT%/*}" | wc -l) file, $(wc -c < "$OUT") bytes"
              ' || echo unable)");
    if (result.out.find("unable") != std::string::npos)
        GTEST_SKIP() << "no disk can be mounted here: " << result.err;
    EXPECT_EQ(result.out, "status 4, 1 file, 40000 bytes\n") << result.err;
    EXPECT_NE(result.err.find("No space left"), std::string::npos) << result.err;
}

/// A scene that needs more memory than the process may have.
void takeMemoryAway() {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer needs more address space than that";
#endif
    GltfBuilder gltf;
    const int mesh = gltf.addShape(box(glm::vec3(1.0f)));
    for (int i = 0; i < 80'000; ++i)
        gltf.addNode({{"mesh", mesh}, {"translation", {i, 0, 0}}});
    const TempFolder folder;
    folder.write("large.glb", gltf.glb());
    const ProcessResult result =
        shell(folder, R"(ulimit -v 400000; exec "$EDGESHADE" pack "${IN%/in/*}/large.glb" "$OUT")");
    EXPECT_EQ(result.status, 3) << result.err;
    expectOneSentence(result);
    EXPECT_NE(result.err.find("memory"), std::string::npos) << result.err;
    expectOldFileAlone(folder);
}

/// A folder without write permission; as root it runs as another user.
void lockAFolder() {
    const TempFolder folder;
    for (const char* part : {".", "out", "in"}) {
        std::filesystem::create_directories(folder / part);
        std::filesystem::permissions(folder / part, std::filesystem::perms(0755));
    }
    const bool root = ::geteuid() == 0;
    const std::string as = root ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
    const ProcessResult result =
        shell(folder, as +
                          "test -x \"$EDGESHADE\" || { echo unable; exit 0; }; "
                          "chmod 555 \"${OUT%/*}\"; " +
                          as +
                          "\"$EDGESHADE\" pack \"$IN\" \"$OUT\"; "
                          "status=$?; chmod 755 \"${OUT%/*}\"; exit $status");
    if (result.out.find("unable") != std::string::npos || result.status == 127)
        GTEST_SKIP() << "nobody else may run the program here";
    EXPECT_EQ(result.status, 4) << result.err;
    EXPECT_NE(result.err.find("Permission denied"), std::string::npos) << result.err;
    expectOldFileAlone(folder);
}

std::vector<Fault> faults() {
    const std::vector<std::string> expanded = {"--encoding", "expanded"};
    const std::vector<std::string> small = {"--size", "320x180"};
    // ulimit -f counts blocks of 512 bytes.
    return {
        refusal("PackBeyondTheAllowedSize", "pack writes more than files may have", 4,
                "ulimit -f 1; exec \"$EDGESHADE\" pack \"$IN\" \"$OUT\" --encoding expanded",
                "File too large"),
        refusal("RenderBeyondTheAllowedSize", "render writes more than files may have", 4,
                "ulimit -f 1; exec \"$EDGESHADE\" render \"$IN\" \"$OUT\" --size 320x180",
                "File too large"),
        refusal("ReportBeyondTheAllowedSize", "a report has more than files may have", 4,
                "ulimit -f 1; exec \"$EDGESHADE\" info \"$IN\" --report \"$OUT\" > /dev/null",
                "File too large"),
        refusal("PackToAFullDevice", "pack writes to a device that is full", 4,
                "exec \"$EDGESHADE\" pack \"$IN\" /dev/full", "No space left"),
        refusal("RenderToAFullDevice", "render writes to a device that is full", 4,
                "exec \"$EDGESHADE\" render \"$IN\" /dev/full --size 16x16", "No space left"),
        refusal("ReportToAFullDevice", "a report goes to a device that is full", 4,
                "exec \"$EDGESHADE\" info \"$IN\" --report /dev/full", "No space left"),
        refusal("StandardOutputFull", "standard output goes to a device that is full", 4,
                "exec \"$EDGESHADE\" info \"$IN\" > /dev/full", "Standard output"),
        refusal("StandardOutputClosed", "standard output is closed", 4,
                "exec \"$EDGESHADE\" info \"$IN\" >&-", "Standard output"),
        {"PackToAFullDisk", "the disk fills up while pack writes", "status 4", fillADisk},
        {"PackIntoALockedFolder", "the folder may not be written into", "status 4", lockAFolder},
        refusal("PackIntoAMissingFolder", "the folder is not there", 4,
                "exec \"$EDGESHADE\" pack \"$IN\" \"$OUT.d/file\"", "No such file"),
        refusal("PackIntoTheSystem", "the folder takes no files", 4,
                "exec \"$EDGESHADE\" pack \"$IN\" /proc/edgeshade.glb", "/proc/edgeshade.glb"),
        refusal("PackOntoAFolder", "the output is a folder", 4,
                "exec \"$EDGESHADE\" pack \"$IN\" \"${OUT%/*}\"", "is a folder"),
        refusal("PackOntoALoopOfLinks", "the output is a link to itself", 4,
                "ln -s loop \"${IN%/*}/loop\"; exec \"$EDGESHADE\" pack \"$IN\" \"${IN%/*}/loop\"",
                "symbolic links"),
        {"TooLittleMemory", "a scene needs more memory than the process may have", "status 3",
         takeMemoryAway},
        interruption("PackInterrupted", "SIGINT (Ctrl-C) at 30 random moments of pack", SIGINT,
                     {"pack", pavilion}, expanded, 120, isPacked),
        interruption("PackTerminated", "SIGTERM at 30 random moments of pack", SIGTERM,
                     {"pack", pavilion}, expanded, 120, isPacked),
        interruption("PackHungUp", "SIGHUP, the terminal closed, at 30 random moments of pack",
                     SIGHUP, {"pack", pavilion}, expanded, 120, isPacked),
        interruption("PackKilled", "SIGKILL at 30 random moments of pack", SIGKILL,
                     {"pack", pavilion}, expanded, 120, isPacked),
        interruption("RenderInterrupted", "SIGINT at 30 random moments of render", SIGINT,
                     {"render", pavilion}, small, 600, isPng),
        {"PacksAtOnce", "four packs write one output at once", "status 0",
         [] {
             packAtOnce(
                 {{"expanded", false}, {"indexed", false}, {"none", false}, {"expanded", false}});
         }},
        {"PacksAtOnceOneTerminated", "three packs write one output, one of them terminated",
         "status 0, signal",
         [] {
             packAtOnce({{"expanded", true}, {"indexed", false}, {"expanded", false}});
         }},
    };
}

class FaultTest : public testing::TestWithParam<Fault> {};

} // namespace

TEST_P(FaultTest, LeavesTheOldFileOrTheNewOne) {
    GetParam().check();
}

INSTANTIATE_TEST_SUITE_P(Table, FaultTest, testing::ValuesIn(faults()),
                         [](const auto& row) { return row.param.name; });

TEST(Faults, AreDocumented) {
    std::vector<std::string> rows;
    for (const Fault& fault : faults())
        rows.push_back("| " + fault.name + " | " + cellOf(fault.what) + " | " + fault.ends + " |");
    EXPECT_GE(rows.size(), 15u);
    expectDocumented("faults", rows);
}

} // namespace edgeshade::test
