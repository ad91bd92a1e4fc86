// Cities in jobs against cities in one, in several formats, and what is wrong with tiles.

#include "src/city/city_files.hpp"
#include "src/city/job.hpp"
#include "src/city/map_sweep.hpp"
#include "src/city/merge.hpp"
#include "src/city/planning.hpp"
#include "tests/city/generated_city.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/temp_folder.hpp"

#include <bit>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace edgeshade::city {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono;

const sun::Place munich{48.14, 11.57};

GeneratedCity cityOf(std::uint32_t seed, double hills) {
    GeneratedCity city;
    city.seed = seed;
    city.hills = hills;
    return city;
}

PlanChoice choiceOf(std::size_t tiles = 1) {
    PlanChoice choice;
    choice.schedule.place = munich;
    choice.schedule.from = choice.schedule.to = 2026y / March / 20;
    choice.schedule.step = minutes(60);
    choice.schedule.minAltitude = 10.0;
    choice.grid = 2.0;
    choice.tiles = tiles;
    return choice;
}

/// All cells of a map, row by row from the north.
struct WholeMap {
    CellRange region;
    std::vector<std::int32_t> lit;
    std::size_t cellsHeld = 0;
};

/// Plans in a folder, and counts what the plan's jobs do.
class CityRun {
  public:
    CityRun(const fs::path& input, const PlanChoice& choice, const std::string& name)
        : results_(folder_ / name) {
        std::vector<std::string> warnings;
        Plan plan = planOf(
            sourcesIn(input, {}), choice, [](double, const std::string&) {}, warnings);
        plan.folder = fs::absolute(plan.folder);
        writeFile(folder_ / "plan.json", std::string_view(textOf(plan)));
        read_ = planFrom(folder_ / "plan.json");
        fs::create_directories(results_);
    }

    const Plan& plan() const { return read_.plan; }
    std::size_t jobs() const { return read_.plan.jobs.size(); }
    Bytes resultOf(std::size_t job, Threads threads = {}) const {
        return bytesOfResult(runJob(
            read_, job, [](double, const std::string&) {}, threads));
    }
    /// Runs all jobs, the last first, and joins them.
    WholeMap map() const {
        runAll();
        return joined();
    }
    void runAll() const {
        for (std::size_t job = jobs(); job >= 1; --job)
            writeFile(results_ / fileNameOfJob(job), resultOf(job));
    }
    WholeMap joined() const {
        WholeMap map{plan().region, {}};
        map.cellsHeld = sweepMap(read_, results_,
                                 {[](const JobResult&) {}, [](std::size_t) {},
                                  [&](const MapRow& row) {
                                      map.lit.insert(map.lit.end(), row.lit.begin(), row.lit.end());
                                  }});
        return map;
    }
    /// Writes the files of all jobs into a folder, and returns the report.
    nlohmann::ordered_json mergeInto(const fs::path& folder) const {
        return mergeCity(
            read_, results_, folder, [](double) { return 0xFFFFFFu; }, [](double) {});
    }
    fs::path resultPath(std::size_t job) const { return results_ / fileNameOfJob(job); }

  private:
    test::TempFolder folder_;
    fs::path results_;
    ReadPlan read_;
};

WholeMap mapOfFolder(const fs::path& input, const PlanChoice& choice) {
    return CityRun(input, choice, "jobs").map();
}

std::size_t surfacesOf(const WholeMap& map) {
    return map.lit.size() - static_cast<std::size_t>(std::ranges::count(map.lit, nothing));
}

class CityTiles : public testing::TestWithParam<std::pair<std::uint32_t, double>> {};

TEST_P(CityTiles, GiveTheBytesOfTheWhole) {
    const auto [seed, hills] = GetParam();
    const test::TempFolder folder;
    cityOf(seed, hills).writeCityJson(folder.path());
    const CityRun whole(folder.path(), choiceOf(), "whole"),
        tiles(folder.path(), choiceOf(16), "tiles");
    EXPECT_EQ(whole.jobs(), 1u);
    EXPECT_GE(tiles.jobs(), 16u);
    // The halos leave casters out, or this would compare a whole with itself.
    EXPECT_TRUE(std::ranges::any_of(tiles.plan().jobs, [&](const Job& job) {
        return job.sources.size() < tiles.plan().sources.size();
    }));
    whole.runAll();
    tiles.runAll();
    const test::TempFolder one, many;
    const auto report = whole.mergeInto(one.path());
    tiles.mergeInto(many.path());
    EXPECT_EQ(one.names(), many.names());
    for (const std::string& name : one.names()) {
        if (name == "report.json") continue; // has the number of jobs
        EXPECT_EQ(readFile(one / name), readFile(many / name)) << name;
    }
    EXPECT_EQ(report["cells_with_surface"], report["cells"]);
    EXPECT_EQ(report["hours"]["min"], 0.0);
    EXPECT_EQ(report["hours"]["max"], report["positions"]); // of an hour each
}

INSTANTIATE_TEST_SUITE_P(Generated, CityTiles,
                         testing::Values(std::pair(1u, 0.0), std::pair(2u, 30.0),
                                         std::pair(3u, 80.0)));

TEST(City, IsTheSameInEveryFormat) {
    const GeneratedCity city = cityOf(4, 25.0);
    std::vector<WholeMap> maps;
    const auto add = [&](const auto& write) {
        const test::TempFolder folder;
        write(folder.path());
        maps.push_back(mapOfFolder(folder.path(), choiceOf(16)));
    };
    add([&](const fs::path& folder) { city.writeCityJson(folder); });
    add([&](const fs::path& folder) { city.writeCityJson(folder, true); });
    add([&](const fs::path& folder) { city.writeCityJsonSequence(folder); });
    add([&](const fs::path& folder) { city.writeGltf(folder); });
    add([&](const fs::path& folder) { city.writeTileset(folder, munich); });
    for (const WholeMap& map : maps) {
        EXPECT_EQ(map.region.columns(), 128);
        EXPECT_EQ(map.lit, maps.front().lit);
    }
}

TEST(City, TilesMayBeListed) {
    const test::TempFolder folder;
    fs::create_directories(folder.path() / "tiles");
    cityOf(4, 25.0).writeCityJson(folder.path() / "tiles");
    std::string text = "# tiles\r\n\n";
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path() / "tiles")) {
        text += "tiles/" + entry.path().filename().string() + "\n";
        ++count;
    }
    const std::string list = folder.write("list.txt", std::string_view(text));
    const SourceList listed = sourcesIn(list, {});
    EXPECT_EQ(listed.sources.size(), count);
    EXPECT_TRUE(std::ranges::is_sorted(listed.sources, {}, &Source::file));
    EXPECT_EQ(mapOfFolder(list, choiceOf(4)).lit,
              mapOfFolder(folder.path() / "tiles", choiceOf(4)).lit);
    folder.write("list.txt", std::string_view(text + text));
    EXPECT_THROW(sourcesIn(list, {}), InputError);
}

TEST(City, ResultsDependOnNothingElse) {
    const test::TempFolder folder;
    cityOf(5, 10.0).writeGltf(folder.path());
    const CityRun run(folder.path(), choiceOf(4), "jobs");
    EXPECT_EQ(run.resultOf(2, {1}), run.resultOf(2, {3}));
}

TEST(City, MemoryDividesTargets) {
    const test::TempFolder folder;
    GeneratedCity city = cityOf(6, 0.0);
    city.writeCityJson(folder.path());
    PlanChoice choice = choiceOf();
    const CityRun wide(folder.path(), choice, "wide");
    choice.memory = wide.plan().jobs.front().memory - 1;
    const CityRun narrow(folder.path(), choice, "narrow");
    EXPECT_GT(narrow.jobs(), 1u);
    for (const Job& job : narrow.plan().jobs)
        EXPECT_LE(job.memory, choice.memory);
    EXPECT_EQ(wide.map().lit, narrow.map().lit);
    choice.memory = 1 << 20;
    try {
        CityRun(folder.path(), choice, "none");
        ADD_FAILURE() << "a megabyte sufficed";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::unavailable);
    }
}

TEST(City, AutoPlaceIsTheTilesOwn) {
    const test::TempFolder cityJson, tiles;
    cityOf(1, 0.0).writeCityJson(cityJson.path());
    cityOf(1, 0.0).writeTileset(tiles.path(), munich);
    PlanChoice choice = choiceOf();
    choice.placeFromSources = true;
    // 691328 east, 5334144 north in UTM zone 32 is in Munich; the grid's north is 1.9 degrees off.
    const hours::Schedule projected = CityRun(cityJson.path(), choice, "p").plan().schedule;
    EXPECT_NEAR(projected.place.latitude, 48.13, 0.02);
    EXPECT_NEAR(projected.place.longitude, 11.57, 0.02);
    EXPECT_NEAR(projected.north, -1.915, 0.02);
    const hours::Schedule earth = CityRun(tiles.path(), choice, "e").plan().schedule;
    EXPECT_NEAR(earth.place.latitude, munich.latitude, 1e-9);
    EXPECT_NEAR(earth.place.longitude, munich.longitude, 1e-9);
}

TEST(City, RastersReachTheirEdges) {
    const GeneratedCity city = cityOf(7, 20.0);
    const auto mapInParts = [&](unsigned parts, std::size_t tiles) {
        const test::TempFolder folder;
        city.writeRaster(folder.path(), 4.0, parts);
        PlanChoice choice = choiceOf(tiles);
        choice.grid = 4.0;
        return mapOfFolder(folder.path(), choice);
    };
    const WholeMap whole = mapInParts(1, 1), halves = mapInParts(2, 1);
    EXPECT_EQ(surfacesOf(whole), whole.lit.size());
    EXPECT_EQ(mapInParts(1, 16).lit, whole.lit);
    EXPECT_EQ(mapInParts(2, 16).lit, halves.lit);
    // Halves differ near their seam alone, where the surface ends with half a pixel.
    ASSERT_EQ(halves.lit.size(), whole.lit.size());
    std::size_t others = 0;
    for (std::size_t cell = 0; cell < whole.lit.size(); ++cell)
        others += std::abs(halves.lit[cell] - whole.lit[cell]) > 1;
    EXPECT_LT(others, whole.lit.size() / 50);
}

TEST(CityFaults, AreOneSentence) {
    const test::TempFolder folder;
    const GeneratedCity city = cityOf(8, 0.0);
    city.writeCityJson(folder.path());
    const auto plan = [&] { CityRun(folder.path(), choiceOf(4), "jobs"); };
    const CityRun run(folder.path(), choiceOf(4), "jobs");
    // A job is missing, or of another plan.
    const test::TempFolder output;
    test::expectInputError([&] { run.mergeInto(output.path()); }, {"Job 1 of 4 has no result"});
    run.map();
    fs::copy_file(run.resultPath(1), run.resultPath(2), fs::copy_options::overwrite_existing);
    test::expectInputError([&] { run.joined(); }, {"job-2.city", "of job 1, not of job 2"});
    Bytes cut = readFile(run.resultPath(1));
    cut.resize(cut.size() - 9);
    writeFile(run.resultPath(1), cut);
    test::expectInputError([&] { run.joined(); }, {"job-1.city", "cut short or broken"});
    // A tile changes or goes after planning.
    const fs::path tile = folder / "tile-0-0.city.json";
    const Bytes whole = readFile(tile);
    Bytes longer = whole;
    longer.push_back(' ');
    writeFile(tile, longer);
    test::expectInputError([&] { run.resultOf(1); }, {"tile-0-0.city.json", "has changed since"});
    fs::remove(tile);
    test::expectInputError([&] { run.resultOf(1); }, {"tile-0-0.city.json"});
    // Tiles overlap, or are broken.
    writeFile(tile, whole);
    writeFile(folder / "again.city.json", whole);
    test::expectInputError(plan, {"the building 'house-0-0'", "must not overlap"});
    fs::remove(folder / "again.city.json");
    writeFile(tile, std::span(whole).first(whole.size() / 2));
    test::expectInputError(plan, {"tile-0-0.city.json", "is not valid JSON"});
    const test::TempFolder rasters;
    city.writeRaster(rasters.path(), 4.0);
    fs::copy_file(rasters / "surface-1.tif", rasters / "twin.tif");
    test::expectInputError([&] { CityRun(rasters.path(), choiceOf(), "jobs"); },
                           {"twin.tif", "overlaps", "surface-1.tif"});
    const Bytes raster = readFile(rasters / "surface-1.tif");
    writeFile(rasters / "twin.tif", std::span(raster).first(4000));
    test::expectInputError([&] { CityRun(rasters.path(), choiceOf(), "jobs"); },
                           {"twin.tif", "TIFF"});
    const test::TempFolder empty;
    test::expectInputError([&] { CityRun(empty.path(), choiceOf(), "jobs"); }, {"has no tile"});
}

TEST(CityFaults, OfTilesetsAreOneSentence) {
    const test::TempFolder folder;
    const auto expect = [&](const std::string& root, std::initializer_list<const char*> words) {
        folder.write("tileset.json", R"({"asset": {"version": "1.1"}, "root": {"boundingVolume": )"
                                     R"({"sphere": [0, 0, 0, 9]}, "geometricError": 0, )" +
                                         root + "}}");
        test::expectInputError([&] { CityRun(folder.path(), choiceOf(), "jobs"); }, words);
    };
    expect(R"("implicitTiling": {}, "content": {"uri": "a.glb"})",
           {"root.implicitTiling", "implicit tiling is not read"});
    expect(R"("content": {"uri": "../a.glb"})", {"root.content.uri", "in the tileset's folder"});
    expect(R"("content": {"uri": "http://a/a.glb"})",
           {"root.content.uri", "in the tileset's folder"});
    expect(R"("content": {"uri": "a.pnts"})", {"root.content.uri", "a.pnts", ".b3dm"});
    expect(R"("content": {"uri": "a.glb"})", {"a.glb"});
    folder.write("a.b3dm", std::string_view("b3dm but short"));
    expect(R"("content": {"uri": "a.b3dm"})", {"a.b3dm", "28 bytes"});
}

TEST(CityFaults, MergeWritesNothing) {
    const test::TempFolder folder, output;
    cityOf(8, 0.0).writeCityJson(folder.path());
    const CityRun run(folder.path(), choiceOf(4), "jobs");
    run.runAll();
    const auto merge = [&] { run.mergeInto(output.path()); };
    // A tile changes after the jobs ran. Its JSON is still sound, and its size the same.
    const fs::path tile = folder / "tile-0-0.city.json";
    const Bytes whole = readFile(tile);
    std::string text(whole.begin(), whole.end());
    text.replace(text.find("house-0-0"), 9, "house-X-X");
    writeFile(tile, std::string_view(text));
    test::expectInputError(merge, {"tile-0-0.city.json", "has changed since the plan was made"});
    writeFile(tile, whole);
    // A result names a tile that is elsewhere.
    JobResult result = resultFrom(run.resultPath(1));
    const auto& sources = run.plan().sources;
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (sources[i].source.file == "tile-3-3.city.json") result.named.front().source = i;
    writeFile(run.resultPath(1), bytesOfResult(result));
    test::expectInputError(merge, {"job-1.city", "which isn't over the job's cells"});
    EXPECT_TRUE(output.names().empty());
}

TEST(City, MonthsAndBitsAddUp) {
    const test::TempFolder folder, one, many;
    cityOf(2, 30.0).writeCityJson(folder.path());
    PlanChoice choice = choiceOf();
    choice.months = choice.bits = true;
    choice.schedule.from = 2026y / March / 31;
    choice.schedule.to = 2026y / April / 1;
    const CityRun whole(folder.path(), choice, "whole");
    choice.tiles = 16;
    const CityRun tiles(folder.path(), choice, "tiles");
    const WholeMap map = whole.map();
    tiles.runAll();
    whole.mergeInto(one.path());
    tiles.mergeInto(many.path());
    for (const char* name : {"hours.tif", "months.tif", "bits.npy"})
        EXPECT_EQ(readFile(one / name), readFile(many / name)) << name;
    // The months of each cell add up to its count, and its bits are as many.
    const JobResult result = resultFrom(whole.resultPath(1));
    const std::size_t rowBytes = hours::bytesOfRow(result.positions);
    std::array<std::size_t, monthsOfYear> byMonth{};
    for (std::size_t cell = 0; cell < result.lit.size(); ++cell) {
        std::size_t ofMonths = 0, ofBits = 0;
        for (std::size_t month = 0; month < monthsOfYear; ++month) {
            ofMonths += result.months[monthsOfYear * cell + month];
            byMonth[month] += result.months[monthsOfYear * cell + month];
        }
        for (std::size_t b = 0; b < rowBytes; ++b)
            ofBits += static_cast<std::size_t>(std::popcount(result.bits[rowBytes * cell + b]));
        ASSERT_EQ(ofMonths, result.lit[cell]);
        ASSERT_EQ(ofBits, result.lit[cell]);
    }
    for (std::size_t month = 0; month < monthsOfYear; ++month)
        EXPECT_EQ(byMonth[month] > 0, month == 2 || month == 3) << month;
    // The array has rows from the north, as the map.
    const Bytes npy = readFile(one / "bits.npy");
    ASSERT_EQ(npy.size() % 64, map.lit.size() * rowBytes % 64);
    const std::size_t data = npy.size() - map.lit.size() * rowBytes;
    for (std::size_t cell = 0; cell < map.lit.size(); ++cell) {
        int bits = 0;
        for (std::size_t b = 0; b < rowBytes; ++b)
            bits += std::popcount(npy[data + rowBytes * cell + b]);
        ASSERT_EQ(bits, map.lit[cell]) << cell;
    }
    // Bits of a year don't fit into a job of that size.
    choice.tiles = 1;
    choice.grid = 0.25;
    choice.schedule.from = 2026y / January / 1;
    choice.schedule.to = 2026y / December / 31;
    choice.schedule.step = minutes(10);
    choice.memory = std::uint64_t{1} << 50;
    const CityRun year(folder.path(), choice, "year");
    EXPECT_GT(year.jobs(), 1u);
    // A result without them is of another plan, whatever it says.
    JobResult bare = result;
    bare.bits.clear();
    writeFile(whole.resultPath(1), bytesOfResult(bare));
    test::expectInputError([&] { whole.joined(); }, {"job-1.city", "months or bits"});
}

TEST(City, MergeHoldsARowOfTargets) {
    const test::TempFolder folder, output;
    cityOf(1, 10.0).writeGltf(folder.path());
    const CityRun run(folder.path(), choiceOf(16), "jobs");
    run.runAll();
    // Sixteen squares of cells: a quarter is in memory at once.
    const nlohmann::ordered_json report = run.mergeInto(output.path());
    EXPECT_EQ(run.jobs(), 16u);
    EXPECT_EQ(report["cells_held"].get<std::size_t>() * 4, report["cells"].get<std::size_t>());
    EXPECT_EQ(output.names(),
              (std::vector<std::string>{"hours.tif", "objects.csv", "preview.png", "report.json"}));
}

TEST(City, WritesHoursIntoCityJson) {
    const test::TempFolder folder;
    cityOf(9, 0.0).writeCityJson(folder.path());
    const CityRun run(folder.path(), choiceOf(), "jobs");
    run.runAll();
    const test::TempFolder output;
    const auto report = run.mergeInto(output.path());
    const std::string name = "hours-" + run.plan().sources[0].source.file;
    const Bytes written = readFile(output / name), table = readFile(output / "objects.csv");
    const auto json = nlohmann::json::parse(written.begin(), written.end());
    const double hours = json["CityObjects"]["house-0-0"]["attributes"]["+sun-hours"].get<double>();
    const std::string csv(table.begin(), table.end());
    // id, building, source, cells, area, mean
    std::istringstream row(csv.substr(csv.find("\nhouse-0-0,") + 1));
    std::string field;
    for (int i = 0; i < 6; ++i)
        std::getline(row, field, ',');
    EXPECT_EQ(hours, std::stod(field));
    EXPECT_GT(hours, 0.0);
    // Seen from above, a city of solids and terrain has roofs and other ground, but no walls.
    const auto kinds = report["by_surface"];
    EXPECT_TRUE(kinds.contains("roof") && kinds.contains("none"));
    EXPECT_FALSE(kinds.contains("wall") || kinds.contains("ground"));
    EXPECT_GT(kinds["roof"]["mean_hours"], kinds["none"]["mean_hours"]);
    // Everything else stays.
    auto stripped = json;
    for (auto& object : stripped["CityObjects"])
        object.erase("attributes");
    const Bytes before = readFile(folder / run.plan().sources[0].source.file);
    EXPECT_EQ(stripped, nlohmann::json::parse(before.begin(), before.end()));
}

} // namespace
} // namespace edgeshade::city
