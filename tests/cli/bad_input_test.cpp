// Bad inputs, given to the real program. It reports what is wrong in one sentence that names the
// file, ends with status 2, and leaves nothing behind; or, if a scene can do without the faulty
// part, it warns in one sentence and draws the rest.
#include "preprocess/base/file_io.hpp"
#include "tests/cli/bad_input.hpp"
#include "tests/cli/documented.hpp"
#include "tests/cli/kept.hpp"
#include "tests/cli/message.hpp"
#include "tests/support/run_edgeshade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

namespace edgeshade::test {
namespace {

constexpr std::size_t mostMemory = std::size_t{1} << 30; // a small file must not take more

/// The table's parts, by what is bad.
struct Kind {
    const char* name;
    std::vector<BadInput> (*rows)();
};
constexpr Kind kinds[] = {{"containers", badContainers},
                          {"JSON", badJson},
                          {"files", badFiles},
                          {"accessors and buffers", badAccessors},
                          {"nodes and meshes", badNodes},
                          {"animations and skins", badAnimations},
                          {"optional parts", badOptionalParts},
                          {"images", badImages},
                          {"compression", badCompression},
                          {"packed shadow data", badShadowData},
                          {"tiles of cities", badCities},
                          {"limits", badLimits}};

std::vector<BadInput> wholeTable() {
    std::vector<BadInput> table;
    for (const Kind& kind : kinds)
        for (BadInput& row : kind.rows())
            table.push_back(std::move(row));
    return table;
}

class BadInputTest : public testing::TestWithParam<BadInput> {};

/// Runs the verb on the row's input in the folder.
ProcessResult run(const BadInput& row, const std::string& verb, const TempFolder& folder,
                  const std::filesystem::path& input) {
    std::vector<std::string> arguments = {verb, input};
    if (verb.starts_with("city")) arguments.push_back("-o");
    if (verb != "info") arguments.push_back(folder / "output");
    if (verb == "render") arguments.insert(arguments.end(), {"--size", "16x16"});
    arguments.insert(arguments.end(), row.options.begin(), row.options.end());
    return runEdgeshade(arguments);
}

/// Outcome of a verb on a row's input.
struct Outcome {
    ProcessResult result;
    std::string input, folder;
    std::vector<std::string> leftBehind; ///< names in the folder besides those from before
    std::optional<Bytes> output;
};

Outcome outcomeIn(const TempFolder& folder, const BadInput& row, const std::string& verb) {
    const std::filesystem::path input = row.make(folder);
    const auto before = folder.names();
    Outcome outcome = {run(row, verb, folder, input), input, folder.path(), {}, {}};
    const auto after = folder.names();
    std::ranges::set_difference(after, before, std::back_inserter(outcome.leftBehind));
    if (exists(folder / "output") && is_regular_file(folder / "output"))
        outcome.output = readFile(folder / "output");
    return outcome;
}

/// Runs each verb of a row once in this process.
const Outcome& outcomeOf(const BadInput& row, const std::string& verb) {
    static std::map<std::pair<std::string, std::string>, Outcome> outcomes;
    return kept(outcomes, {row.name, verb}, [&] {
        const TempFolder folder;
        return outcomeIn(folder, row, verb);
    });
}

void expectRefused(const BadInput& row, const std::string& verb) {
    SCOPED_TRACE(verb);
    const auto& [result, input, folder, leftBehind, output] = outcomeOf(row, verb);
    ASSERT_NE(result.status, 0) << "it was accepted";
    ASSERT_EQ(result.signal, 0);
    EXPECT_EQ(result.status, 2);
    EXPECT_FALSE(result.timedOut);
    EXPECT_LT(result.peakBytes, mostMemory);
    expectOneSentence(result);
    EXPECT_NE(messageOf(result).find(input), std::string::npos) << "the file is not named";
    for (const std::string& word : row.words)
        EXPECT_NE(messageOf(result).find(word), std::string::npos) << "'" << word << "' is missing";
    EXPECT_EQ(leftBehind, std::vector<std::string>());
    EXPECT_EQ(result.out, "");
}

const Bytes& pictureOfSoundScene() {
    static const Bytes picture = [] {
        const TempFolder folder;
        const auto input = folder.write("sound.glb", soundScene().glb());
        runEdgeshade({"render", input, folder / "output", "--size", "16x16"});
        return readFile(folder / "output");
    }();
    return picture;
}

void expectWarned(const BadInput& row, const std::string& verb) {
    SCOPED_TRACE(verb);
    const auto& [result, input, folder, leftBehind, output] = outcomeOf(row, verb);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_LT(result.peakBytes, mostMemory);
    const std::string warning = warningsOf(result);
    EXPECT_EQ(std::count(warning.begin(), warning.end(), '\n'), 0) << warning;
    EXPECT_TRUE(warning.ends_with(".") && !warning.ends_with("..")) << warning;
    EXPECT_NE(warning.find(input), std::string::npos) << "the file is not named";
    for (const std::string& word : row.words)
        EXPECT_NE(warning.find(word), std::string::npos)
            << "'" << word << "' is missing from: " << warning;
    if (verb == "render") {
        EXPECT_EQ(output, pictureOfSoundScene());
    }
}

/// The answer of the row's first verb, without the folder, as the documentation shows it.
struct Answer {
    int status;
    std::string cell; ///< of a table
};

Answer answerTo(const BadInput& row) {
    const Outcome& outcome = outcomeOf(row, row.verbs.front());
    const std::string message = withoutFolder(
        row.warned ? warningsOf(outcome.result) : messageOf(outcome.result), outcome.folder);
    return {outcome.result.status,
            cellOf(message.substr(row.warned ? 0 : std::string("edgeshade: ").size()))};
}

} // namespace

TEST_P(BadInputTest, IsToldOf) {
    for (const std::string& verb : GetParam().verbs)
        GetParam().warned ? expectWarned(GetParam(), verb) : expectRefused(GetParam(), verb);
}

void PrintTo(const BadInput& row, std::ostream* stream) {
    *stream << row.name;
}

INSTANTIATE_TEST_SUITE_P(Table, BadInputTest, testing::ValuesIn(wholeTable()),
                         [](const auto& row) { return row.param.name; });

TEST(BadInput, TheTableIsDocumented) {
    std::vector<std::string> rows, kindRows;
    for (const Kind& kind : kinds) {
        const std::vector<BadInput> inputs = kind.rows();
        std::string example; // one from the middle
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const Answer answer = answerTo(inputs[i]);
            rows.push_back("| " + inputs[i].name + " | " + inputs[i].verbs.front() + " | " +
                           std::to_string(answer.status) + " | " + answer.cell + " |");
            if (i == inputs.size() / 2) example = answer.cell;
        }
        kindRows.push_back("| " + std::string(kind.name) + " | " + std::to_string(inputs.size()) +
                           " | " + example + " |");
    }
    EXPECT_GE(rows.size(), 60u);
    expectDocumented("inputs", rows, "bad-inputs-list.md");
    expectDocumented("kinds", kindRows);
}

TEST(BadInput, TheSceneOfTheTableIsSound) {
    const TempFolder folder;
    const auto input = folder.write("sound.glb", soundScene().glb());
    EXPECT_EQ(runEdgeshade({"info", input}).status, 0);
    EXPECT_EQ(runEdgeshade({"pack", input, folder / "packed.glb"}).status, 0);
    EXPECT_EQ(runEdgeshade({"render", input, folder / "picture.png", "--size", "16x16"}).status, 0);
}

} // namespace edgeshade::test
