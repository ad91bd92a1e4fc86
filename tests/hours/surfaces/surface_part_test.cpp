// Parts of runs over surfaces as files, including hostile ones, and merging them.
#include "preprocess/base/error.hpp"
#include "src/hours/part_json.hpp"
#include "src/hours/surfaces/division.hpp"
#include "src/hours/surfaces/surface_merge.hpp"
#include "src/hours/surfaces/surface_part_file.hpp"
#include "tests/support/scene_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t positionsOfRun = 13;

/// Whether position i lights a cell.
bool isLit(std::size_t cell, std::size_t i) {
    return (i * (cell + 3)) % 5 < 2;
}

/// Four cells of a wall, of the chosen one of two quads.
SurfacePart surfacePart(std::size_t number, std::size_t of) {
    const Scene scene = test::SceneBuilder()
                            .quad({0, 0, 5}, {1, 0, 5}, {1, 0, 4}, {0, 0, 4})
                            .material(Material())
                            .quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})
                            .scene();
    SurfacePart part;
    part.number = number;
    part.of = of;
    part.positionsOfRun = positionsOfRun;
    part.scene = worldTriangles(scene, [](std::uint32_t, std::uint32_t) { return true; });
    SurfaceRun& run = part.run;
    run.cells = cellsOf(scene, [](std::uint32_t, std::uint32_t material) { return material == 1; },
                        {0.5, 0.0});
    run.cells.cells[2].state = CellState::within;
    for (const WorldTriangle& triangle : run.cells.triangles)
        run.nodes[triangle.node] = "wall";
    run.materials = {{1, "brick \"red\""}};
    run.settings = {
        {"file", "wall.glb"},     {"from", "2026-03-21"},
        {"to", "2026-03-21"},     {"step", 30},
        {"utc-offset", "+01:00"}, {"place", {48.0, 11.0}},
        {"threshold", nullptr},   {"surfaces", {{"unit", 2.0}, {"windows", Json::array()}}}};
    run.step = std::chrono::minutes(30);
    run.offset = std::chrono::minutes(60);
    run.unit = 2.0;
    run.scene = "0123456789abcdef";
    run.version = "1.2.3";
    run.files = {{{"name", "wall.glb"}, {"sha256", "00"}}};
    std::vector<Position> positions;
    for (std::size_t i = 0; i < positionsOfRun; ++i) {
        const double angle = 0.1 * static_cast<double>(i) + 0.123456789012345678;
        positions.push_back({sun::Instant(std::chrono::seconds(1774080000 + 1800 * i)),
                             angle,
                             50.0 * angle,
                             {0.0, std::sin(angle), std::cos(angle)}});
        part.beam.push_back(1000.0 * angle / 3.0);
    }
    run.positions = ofPart(positions, number, of);
    const LightQuestion question = questionOf(
        run, 1, of == 1 ? std::span<const double>(part.beam) : std::span<const double>(), true);
    run.light = lightOf(run.cells, question, CellBits([&](std::size_t first, std::size_t end) {
                            rays::LitBits bits(end - first, run.positions.size());
                            for (std::size_t cell = first; cell < end; ++cell)
                                for (std::size_t i = 0; i < run.positions.size(); ++i)
                                    if (isLit(cell, i * of + number - 1))
                                        bits.setLit(cell - first, i);
                            return bits;
                        }),
                        [](double) {});
    return part;
}

SurfacePart readPart(const std::string& text) {
    return surfacePartFrom("k.part", Json::parse(text));
}

/// The error message for a part's file that was tampered with.
std::string messageWith(const std::function<void(Json&)>& tamper) {
    Json json = Json::parse(textOf(surfacePart(2, 3)));
    tamper(json);
    try {
        surfacePartFrom("k.part", json);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

template <class T>
std::string uri(const std::vector<T>& values) {
    return packed(std::span<const T>(values));
}

void expectWords(const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        EXPECT_NE(message.find(word), std::string::npos) << "'" << message << "' lacks " << word;
}

} // namespace

TEST(SurfacePartFile, HoldsAllOfAPart) {
    const SurfacePart part = surfacePart(2, 3);
    const std::string text = textOf(part);
    EXPECT_TRUE(textOf(readPart(text)) == text);
    const SurfacePart read = readPart(text);
    ASSERT_EQ(read.run.cells.cells.size(), 4u);
    EXPECT_EQ(read.run.cells.corners, part.run.cells.corners);
    EXPECT_EQ(read.run.cells.cells[3].point, part.run.cells.cells[3].point);
    EXPECT_EQ(read.run.cells.cells[2].state, CellState::within);
    EXPECT_EQ(read.run.cells.triangles.size(), 2u);
    EXPECT_EQ(read.scene.size(), 4u);
    EXPECT_EQ(read.run.light.bits, part.run.light.bits);
    EXPECT_EQ(read.run.positions[1].direction, part.run.positions[1].direction);
    EXPECT_EQ(read.beam, part.beam);
    EXPECT_EQ(read.run.unit, 2.0);
    EXPECT_EQ(read.run.nodes, part.run.nodes);
}

TEST(SurfacePartFile, BytesAreThoseOfItsArrays) {
    const SurfacePart part = surfacePart(1, 1);
    const CellArrays arrays = arraysOf(part.run.cells, part.scene);
    std::uint64_t bytes = part.run.light.bits.size();
    forEachArray([&](const ArrayName&, auto array) {
        bytes += (arrays.*array).size() * sizeof(arrays.*array)[0];
    });
    EXPECT_EQ(bytesOfPart(part.run.cells, part.scene.size(), positionsOfRun), bytes);
}

TEST(SurfacePartFile, SaysWhatIsWrong) {
    const std::vector<double> corners(4 * 9, 0.25);
    struct Row {
        std::function<void(Json&)> tamper;
        std::vector<std::string> said;
    };
    const Row rows[] = {
        {[](Json& j) { j["edgeshade_sunhours_surfaces_part"] = 2; }, {"version 1", "2"}},
        {[](Json& j) { j["part"] = 4; }, {"part is 4", "1 to 3"}},
        {[](Json& j) { j["positions"].erase(0); }, {"positions has 3", "has 4"}},
        {[](Json& j) { j["settings"]["surfaces"]["unit"] = 0; }, {"settings.surfaces.unit"}},
        {[](Json& j) { j["settings"]["surfaces"].erase("windows"); }, {"windows"}},
        {[](Json& j) { j["beam"] = uri(std::vector<double>(13, -1.0)); }, {"beam", "-1"}},
        {[](Json& j) { j["beam"] = "data:,"; }, {"beam", "104 bytes"}},
        {[](Json& j) { j["bits"] = j["cells"]["state"] = "data:,"; }, {"cells.state", "4 bytes"}},
        {[](Json& j) { j["bits"] = uri(std::vector<std::uint8_t>(4, 0x08)); },
         {"bits of cell 0", "beyond the part's 4 positions"}},
        {[](Json& j) { j["bits"] = uri(std::vector<std::uint8_t>(3, 0)); }, {"bits", "4 bytes"}},
        {[](Json& j) { j["cells"]["count"] = 1u << 30; }, {"cells.count", "1073741824 bytes"}},
        {[](Json& j) { j["cells"]["count"] = 1e18; }, {"cells.count"}},
        {[](Json& j) { j["cells"]["count"] = -1; }, {"cells.count"}},
        {[](Json& j) {
             j["cells"]["triangle"] = uri(std::vector<std::uint32_t>{0, 1, 1, 2});
         },
         {"cells.triangle at 3 is 2", "no chosen triangle"}},
        {[](Json& j) {
             j["cells"]["state"] = uri(std::vector<std::uint8_t>{0, 3, 0, 0});
         },
         {"cells.state at 1 is 3"}},
        {[](Json& j) {
             j["cells"]["area"] = uri(std::vector<double>{1, 1, -1, 1});
         },
         {"cells.area at 2 is -1"}},
        {[](Json& j) {
             j["cells"]["area"] = uri(std::vector<double>{1, 1, NAN, 1});
         },
         {"cells.area of cell 2 is not finite"}},
        {[](Json& j) {
             j["cells"]["face_count"] = uri(std::vector<std::uint32_t>{1, 1, 0, 1});
         },
         {"cells.face_count at 2 is 0"}},
        {[](Json& j) {
             j["cells"]["first_face"] = uri(std::vector<std::uint32_t>{0, 1, 2, 0xFFFFFFFF});
         },
         {"cells.face_count at 3", "beyond the last face"}},
        {[](Json& j) { j["faces"]["corner_count"] = uri(std::vector<std::uint32_t>(6, 2)); },
         {"faces.corner_count at 0 is 2"}},
        {[](Json& j) { j["faces"]["first_corner"] = uri(std::vector<std::uint32_t>(6, 999)); },
         {"faces.corner_count at 0", "beyond the last corner"}},
        {[](Json& j) { j["triangles"]["chosen"] = uri(std::vector<std::uint8_t>(4, 2)); },
         {"triangles.chosen at 0 is 2"}},
        {[](Json& j) { j["triangles"]["material"] = uri(std::vector<std::uint32_t>(4, 7)); },
         {"triangles.material at 2 is 7", "no name"}},
        {[](Json& j) { j["nodes"] = Json::array(); }, {"triangles.node", "no name"}},
        {[](Json& j) { j["triangles"]["corners"] = "data:;base64,@"; }, {"triangles.corners"}},
        {[](Json& j) { j.erase("corners"); }, {"corners"}},
    };
    for (const Row& row : rows)
        expectWords(messageWith(row.tamper), row.said);
    EXPECT_EQ(messageWith([&](Json& j) { j["triangles"]["corners"] = uri(corners); }), "");
}

TEST(SurfaceMergeTest, PartsAreTheWhole) {
    const SurfacePart whole = surfacePart(1, 1);
    for (const std::size_t of : {1u, 2u, 3u, 13u, 15u}) { // of 15, two have no positions
        SurfaceMerge merge;
        for (std::size_t k = of; k >= 1; --k)
            merge.add("part " + std::to_string(k), readPart(textOf(surfacePart(k, of))));
        EXPECT_EQ(merge.cells(), 4u);
        EXPECT_EQ(merge.positions(), positionsOfRun);
        const SurfacePart merged = std::move(merge).whole(true, [](double) {});
        EXPECT_TRUE(textOf(merged) == textOf(whole)) << of;
        EXPECT_EQ(merged.run.light.lit, whole.run.light.lit) << of;
        EXPECT_EQ(merged.run.light.first, whole.run.light.first) << of;
        EXPECT_EQ(merged.run.light.last, whole.run.light.last) << of;
        EXPECT_EQ(merged.run.light.directKwh, whole.run.light.directKwh) << of;
    }
}

TEST(SurfaceMergeTest, WantsPartsOfOneRun) {
    const auto messageFor = [](const std::function<void(SurfacePart&)>& change,
                               std::size_t number = 1) {
        SurfaceMerge merge;
        SurfacePart part = surfacePart(number, 3);
        change(part);
        try {
            merge.add("a", surfacePart(2, 3));
            merge.add("b", std::move(part));
            merge.add("c", surfacePart(3, 3));
            std::move(merge).whole(false, [](double) {});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(messageFor([](SurfacePart&) {}), "");
    expectWords(messageFor([](SurfacePart& p) { p.run.scene = "1"; }), {"'b': scene is", "'a'"});
    expectWords(messageFor([](SurfacePart& p) { p.run.version = "1"; }), {"version"});
    expectWords(messageFor([](SurfacePart& p) { p.run.files[0]["sha256"] = "1"; }), {"files"});
    expectWords(messageFor([](SurfacePart& p) { p.run.settings["step"] = 20; }),
                {"settings.step is 20"});
    expectWords(messageFor([](SurfacePart& p) { p.beam[4] = 0.5; }), {"beam of position 4 is 0.5"});
    expectWords(messageFor([](SurfacePart& p) { p.beam.clear(); }), {"beam is of length 0"});
    expectWords(messageFor([](SurfacePart& p) { p.run.cells.cells[3].point.z = 9.0; }),
                {"cells.point of cell 3 is 9"});
    expectWords(messageFor([](SurfacePart& p) { p.scene.pop_back(); }), {"triangles.corners"});
    expectWords(
        messageFor([](SurfacePart& p) { p.run.positions[0].time += std::chrono::hours(9); }),
        {"'a': positions[0].time is not later"});
    expectWords(messageFor([](SurfacePart&) {}, 2), {"'b': part is 2", "'a' already"});
}

} // namespace edgeshade::hours
