// Parts as files, including hostile ones, and merging them.
#include "preprocess/base/error.hpp"
#include "src/hours/merge.hpp"
#include "src/hours/part_file.hpp"
#include "src/hours/report.hpp"
#include "tests/support/temp_folder.hpp"

#include <functional>
#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t positionsOfRun = 7;

/// Six pixels and a probe; the number of position i decides what it lights.
Part partOf(std::size_t number, std::size_t of) {
    Part part;
    part.number = number;
    part.of = of;
    part.settings = {{"file", "yard.glb"},   {"place", {48.0, 11.0}},
                     {"from", "2026-03-21"}, {"to", "2026-03-21"},
                     {"step", 60},           {"utc-offset", "+01:00"},
                     {"threshold", 2.0},     {"preset", nullptr}};
    part.camera = {{"ortho", 10.0}};
    part.scene = "0123456789abcdef";
    part.warnings = {"It is late."};
    part.positionsOfRun = positionsOfRun;
    part.offset = std::chrono::minutes(60);
    Exposure& exposure = part.exposure;
    exposure.width = 3;
    exposure.height = 2;
    exposure.lit.assign(6, 0);
    exposure.surface = {1, 1, 1, 1, 1, 0};
    exposure.area = {0.1f, 0.2f, 0.3f, 1e-20f, 7e20f, 0.0f};
    exposure.material = {0, 0, 5, 5, Exposure::none, Exposure::none};
    exposure.node = {1, 2, 3, 3, Exposure::none, Exposure::none};
    part.materials = {{0, "brick"}, {5, "glass \"double\""}};
    part.nodes = {{1, "a"}, {2, "a"}, {3, "nodes[3]"}};
    Probe probe;
    probe.point = {0.1, 0.2, 0.3};
    probe.normal = glm::dvec3(0.0, 1.0, 0.0);
    for (std::size_t i = number - 1; i < positionsOfRun; i += of) {
        const double angle = 0.1 * static_cast<double>(i) + 0.123456789012345678;
        part.positions.push_back({sun::Instant(std::chrono::seconds(1774080000 + 3600 * i)),
                                  100.0 * angle, 50.0 * angle,
                                  glm::dvec3(std::sin(angle), std::cos(angle), 0.0)});
        for (std::size_t p = 0; p < 6; ++p)
            if ((i * (p + 3)) % 5 < 2) ++exposure.lit[p];
        probe.lit.push_back(i % 3 == 1);
    }
    part.probes = {probe};
    return part;
}

std::vector<PartOfFile> split(std::size_t of) {
    std::vector<PartOfFile> parts;
    for (std::size_t k = of; k >= 1; --k) // in another order
        parts.push_back({"part " + std::to_string(k), partOf(k, of)});
    return parts;
}

std::string reportText(const Part& whole) {
    const std::filesystem::path path("whole");
    return reportOf(whole, hoursSettings(JsonField(path, whole.settings))).dump();
}

class PartFile : public testing::Test {
  protected:
    std::string fileOf(const std::string& text) {
        return folder_.write("k.part", Bytes(text.begin(), text.end()));
    }

    /// The error message for a part file that was tampered with.
    std::string messageOf(const std::function<void(Json&)>& tamper) {
        Json json = Json::parse(textOf(partOf(2, 3)));
        tamper(json);
        return messageOfText(json.dump());
    }

    std::string messageOfText(const std::string& text) {
        const std::string path = fileOf(text);
        try {
            partFrom(path);
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("k.part"), std::string::npos);
            return error.what();
        }
        return "";
    }

    test::TempFolder folder_;
};

std::string mergeMessage(std::vector<PartOfFile> parts) {
    try {
        merged(parts);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

void expectWords(const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(message.find(word), std::string::npos) << "'" << message << "' lacks " << word;
}

} // namespace

TEST_F(PartFile, HoldsAllOfAPart) {
    const std::string text = textOf(partOf(2, 3));
    EXPECT_EQ(textOf(partFrom(fileOf(text))), text);
    const Part read = partFrom(fileOf(text));
    EXPECT_EQ(read.exposure.area, partOf(2, 3).exposure.area);
    EXPECT_EQ(read.exposure.lit, partOf(2, 3).exposure.lit);
    EXPECT_EQ(read.positions[1].direction, partOf(2, 3).positions[1].direction);
    EXPECT_EQ(read.probes[0].lit, partOf(2, 3).probes[0].lit);
}

TEST_F(PartFile, TruncatedAnywhereIsRefused) {
    const std::string text = textOf(partOf(1, 2));
    for (std::size_t length = 0; length + 3 < text.size(); length += 7)
        EXPECT_NE(messageOfText(text.substr(0, length)), "") << length;
}

TEST_F(PartFile, SaysWhatIsWrong) {
    expectWords(messageOfText("[]"), {"k.part"});
    expectWords(messageOfText("GIF89a"), {"not a part of a sunhours run"});
    expectWords(messageOf([](Json& j) { j.erase("edgeshade_sunhours_part"); }),
                {"edgeshade_sunhours_part"});
    expectWords(messageOf([](Json& j) { j["edgeshade_sunhours_part"] = 2; }), {"version 1", "2"});
    expectWords(messageOf([](Json& j) { j["part"] = 4; }), {"part is 4", "1 to 3"});
    expectWords(messageOf([](Json& j) { j["part"] = 0; }), {"part is 0"});
    expectWords(messageOf([](Json& j) { j["parts"] = 1e9; }), {"parts"});
    expectWords(messageOf([](Json& j) { j["positions"].erase(0); }), {"positions has 1", "has 2"});
    expectWords(messageOf([](Json& j) { j["positions_of_run"] = 70000; }),
                {"positions_of_run", "65535"});
    expectWords(messageOf([](Json& j) { j["positions"][1]["time"] = "noon"; }),
                {"positions[1].time", "noon"});
    expectWords(messageOf([](Json& j) { j["positions"][0]["time"] = "2026-03-21T09:00+02:00"; }),
                {"positions[0].time", "offset"});
    expectWords(messageOf([](Json& j) { j["size"] = {0, 2}; }), {"size is [0,2]"});
    expectWords(messageOf([](Json& j) { j["size"] = {65536, 65536}; }), {"size"});
    expectWords(messageOf([](Json& j) { j["size"] = {3, 3}; }), {"pixels.lit", "18 bytes"});
    expectWords(messageOf([](Json& j) { j["pixels"]["lit"] = "data:,x"; }), {"pixels.lit"});
    expectWords(messageOf([](Json& j) { j["pixels"]["area"] = "data:;base64,@"; }),
                {"pixels.area"});
    expectWords(messageOf([](Json& j) { j["pixels"]["lit"] = j["pixels"]["surface"]; }),
                {"pixels.lit"});
    expectWords(messageOf([](Json& j) { j["materials"].erase(1); }), {"pixels.material", "5"});
    expectWords(messageOf([](Json& j) { j["nodes"][1]["index"] = 1; }),
                {"nodes[1].index", "twice"});
    expectWords(messageOf([](Json& j) { j["probes"][0]["lit"] = "0"; }), {"probes[0].lit", "2"});
    expectWords(messageOf([](Json& j) { j["settings"]["step"] = 0; }), {"settings.step is 0"});
    expectWords(messageOf([](Json& j) { j["settings"]["to"] = "2025-01-01"; }), {"settings.to"});
    expectWords(messageOf([](Json& j) { j["settings"]["preset"] = "moon"; }),
                {"settings.preset", "moon"});
}

TEST_F(PartFile, CountsBeyondItsPositionsAreRefused) {
    Part part = partOf(2, 3);
    part.exposure.lit[4] = 3;
    expectWords(messageOfText(textOf(part)), {"pixels.lit of pixel 4 is 3", "2 positions"});
    part = partOf(2, 3);
    part.exposure.area[1] = -1.0f;
    expectWords(messageOfText(textOf(part)), {"pixels.area of pixel 1"});
    part = partOf(2, 3);
    part.exposure.surface[0] = 2;
    expectWords(messageOfText(textOf(part)), {"pixels.surface of pixel 0 is 2"});
}

TEST(Merge, PartsAreTheWhole) {
    const std::string whole = textOf(partOf(1, 1)), report = reportText(partOf(1, 1));
    for (const std::size_t of : {1u, 2u, 3u, 7u, 9u}) { // of 9, two have no positions
        EXPECT_EQ(textOf(merged(split(of))), whole) << of;
        EXPECT_EQ(reportText(merged(split(of))), report) << of;
    }
}

TEST(Merge, WantsEachPartOnce) {
    std::vector<PartOfFile> parts = split(3);
    parts.pop_back();
    expectWords(mergeMessage(parts), {"'part 3': parts is 3, but part 1 is missing"});
    parts = split(3);
    parts.push_back({"copy", partOf(2, 3)});
    expectWords(mergeMessage(parts), {"'copy': part is 2, but 'part 2' already has that number"});
}

TEST(Merge, WantsPartsOfOneRun) {
    const auto messageWith = [](const std::function<void(Part&)>& change) {
        std::vector<PartOfFile> parts = split(3);
        change(parts[1].part);
        return mergeMessage(parts);
    };
    expectWords(messageWith([](Part& p) { p.settings["step"] = 30; }),
                {"'part 2'", "settings.step is 30", "'part 3' it is 60"});
    expectWords(messageWith([](Part& p) { p.settings["more"] = 1; }), {"settings.more is 1"});
    expectWords(messageWith([](Part& p) { p.scene = "0"; }), {"scene"});
    expectWords(messageWith([](Part& p) { p.camera["ortho"] = 11.0; }), {"camera.ortho is 11"});
    expectWords(messageWith([](Part& p) { p.probes[0].point.x = 9.0; }), {"probes"});
    expectWords(messageWith([](Part& p) { p.nodes[3] = "b"; }), {"nodes", "part 3"});
    expectWords(messageWith([](Part& p) { p.exposure.area[2] = 5.0f; }),
                {"pixels.area of pixel 2"});
    expectWords(messageWith([](Part& p) { p.positions[0].time -= std::chrono::hours(9); }),
                {"'part 2': positions[0].time"});
    std::vector<PartOfFile> parts = split(3);
    parts[0].part = partOf(1, 2);
    expectWords(mergeMessage(parts), {"parts is 3", "2"});
}

} // namespace edgeshade::hours
