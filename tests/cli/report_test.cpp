// The JSON reports of `pack` and `info`.
#include "tests/support/packing.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A folder with a mixed scene.
class Report : public testing::Test {
  protected:
    Report() : input_(folder_.write("in.glb", variedScene().glb())) {}

    Json packReport(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"pack", input_, output_, "--report",
                                              folder_ / "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = runEdgeshade(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        const Bytes report = readFile(folder_ / "report.json");
        return Json::parse(report.begin(), report.end());
    }

    Json infoReport(const std::string& file) const {
        const ProcessResult result = runEdgeshade({"info", file, "--report", "-"});
        EXPECT_EQ(result.status, 0) << result.err;
        return Json::parse(result.out);
    }

    static void expectContractKeys(const Json& report) {
        for (const char* key :
             {"triangles", "degenerate_triangles", "edges", "largest_opposite_count", "components",
              "closed_oriented_triangles", "flat_edges_dropped", "records"})
            EXPECT_TRUE(report.contains(key) && report[key].is_number_unsigned()) << key;
        for (const char* key : {"sides", "caps", "published_equation", "file"})
            EXPECT_TRUE(report["bytes"].contains(key)) << key;
        for (const char* key : {"sides", "caps", "published"})
            EXPECT_TRUE(report["vertex_runs"].contains(key)) << key;
        for (const char* key : {"read", "weld", "edges", "pack"})
            EXPECT_TRUE(report["seconds"].contains(key)) << key;
        EXPECT_TRUE(report["edges_by_opposite_count"].is_object());
        EXPECT_TRUE(report["warnings"].is_array());
    }

    TempFolder folder_;
    std::string input_;
    std::string output_ = folder_ / "out.glb";
};

} // namespace

TEST_F(Report, PackHasTheKeysOfTheContract) {
    expectContractKeys(packReport());
}

TEST_F(Report, InfoHasTheKeysOfTheContractForRawAndPackedFiles) {
    expectContractKeys(infoReport(input_));
    packReport();
    expectContractKeys(infoReport(output_));
}

TEST_F(Report, TheFiguresAreThoseOfTheScene) {
    const Json report = packReport();
    // Opaque: two boxes of 12 triangles, a book of 7 pages; further a box and a tetrahedron of 12
    // and 4 that blend, and one of 4 that is masked, with a degenerate triangle.
    EXPECT_EQ(report["triangles"], 12 + 7 + 5 + 12 + 12 + 4);
    EXPECT_EQ(report["degenerate_triangles"], 0);
    EXPECT_EQ(report["edges"], 18 + 18 + 15);
    EXPECT_EQ(report["edges_by_opposite_count"], Json({{"1", 14}, {"2", 36}, {"7", 1}}));
    EXPECT_EQ(report["largest_opposite_count"], 7);
    EXPECT_EQ(report["components"], 3);
    EXPECT_EQ(report["closed_oriented_triangles"], 24);
    EXPECT_EQ(report["flat_edges_dropped"], 6 + 6); // the boxes' diagonals
    EXPECT_EQ(report["records"], 12 + 12 + 14 + 4);
    EXPECT_EQ(report["bytes"]["sides"], (12 + 12 + 3) * 56 + (14 + 1) * 40);
    EXPECT_EQ(report["bytes"]["caps"], 31 * 52);
    EXPECT_EQ(report["vertex_runs"]["sides"], 4 * (12 + 12) + 4 * (2 * 3 + 15));
    EXPECT_EQ(report["vertex_runs"]["published"], 6 * 7 * 51 + 6 * 31);
    EXPECT_EQ(report["bytes"]["published_equation"], 16 * (2 + 7) * 51 + 48 * 31);
    EXPECT_EQ(report["bytes"]["file"], std::filesystem::file_size(output_));
}

TEST_F(Report, MaskedCastersCountOnlyOnDemand) {
    const Json report = packReport({"--cast-masked"});
    EXPECT_EQ(report["degenerate_triangles"], 1);
    // The masked tetrahedron shares the edge of the book.
    EXPECT_EQ(report["edges"], 3 * 18 + 15 + 2 * 6 - 1);
    EXPECT_EQ(report["largest_opposite_count"], 7 + 2);
}

TEST_F(Report, InfoOfAPackedFileTellsWhatInfoOfItsSourceTells) {
    packReport({"--encoding", "expanded"});
    Json raw = infoReport(input_), packedFile = infoReport(output_);
    EXPECT_EQ(raw["encoding"], nullptr);
    EXPECT_EQ(packedFile["encoding"], "expanded");
    for (Json* report : {&raw, &packedFile}) {
        EXPECT_GT((*report)["bytes"]["file"], 0);
        report->erase("encoding");
        report->erase("seconds");
        (*report)["bytes"].erase("file");
        (*report)["bytes"].erase("stored");
    }
    EXPECT_EQ(packedFile, raw);
}

TEST_F(Report, InfoOfAPackedFileUsesItsSettings) {
    packReport({"--cast-masked"});
    EXPECT_EQ(infoReport(output_)["degenerate_triangles"], 1);
}

TEST_F(Report, SimplifiedCastersAreCountedBeforeAndAfter) {
    const Json exact = packReport();
    EXPECT_EQ(exact["casting_surface_triangles"], 31);
    EXPECT_EQ(exact["casting_triangles"], 31);
    const Json coarse = packReport({"--caster-error", "5"});
    EXPECT_EQ(coarse["casting_surface_triangles"], 31);
    EXPECT_LT(coarse["casting_triangles"], 31);
    EXPECT_EQ(coarse["settings"]["caster-error"], 5.0);
    EXPECT_EQ(infoReport(output_)["casting_triangles"], coarse["casting_triangles"]);
    EXPECT_EQ(infoReport(output_)["settings"], coarse["settings"]);
}

TEST_F(Report, AFlatToleranceDropsEdges) {
    const Json exact = packReport(), flat = packReport({"--flat-tolerance", "44"});
    EXPECT_EQ(flat["settings"]["flat-tolerance"], 44.0);
    EXPECT_GE(flat["flat_edges_dropped"], exact["flat_edges_dropped"]);
    EXPECT_EQ(infoReport(output_)["settings"], flat["settings"]);
    EXPECT_EQ(infoReport(output_)["records"], flat["records"]);
}

TEST_F(Report, OnStandardOutputItIsAlone) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"info", input_},
          {"pack", input_, output_},
          {"render", input_, folder_ / "out.png", "--size", "16x16"}}) {
        SCOPED_TRACE(arguments[0]);
        std::vector<std::string> withReport = arguments;
        withReport.insert(withReport.end(), {"--report", "-"});
        const ProcessResult result = runEdgeshade(withReport);
        EXPECT_EQ(result.status, 0);
        EXPECT_TRUE(Json::accept(result.out)) << result.out;
        EXPECT_NE(result.err, "");
        EXPECT_NE(runEdgeshade(arguments).out, "");
    }
}

TEST_F(Report, RenderingWithAMapHasNoRecordsOfVolumes) {
    const auto rendering = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {
            "render", input_, folder_ / "out.png", "--size", "16x16", "--report", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return Json::parse(runEdgeshade(arguments).out);
    };
    const auto bytes = [&](const std::vector<std::string>& more) {
        return rendering(more)["bytes_gpu"].get<int>();
    };
    EXPECT_EQ(bytes({"--shadows", "none"}), 0);
    const int map = bytes({"--shadows", "map", "--map-size", "64"});
    EXPECT_GE(map, 64 * 64 * 4);
    EXPECT_LE(map, 64 * 64 * 8);
    EXPECT_GT(bytes({}), 0);
    // Two colours, depth and stencil: at least 11 bytes for each of 8 x 8 texels.
    const int alone = bytes({});
    EXPECT_GE(bytes({"--mask-scale", "1/2"}), alone + 8 * 8 * 11);
}

TEST_F(Report, WarningsAreInItAndOnStandardError) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    gltf.addShapeNode({zigzag(), {}, {}, {}}, {{"mode", 0}});
    const ProcessResult result =
        runEdgeshade({"info", folder_.write("points.glb", gltf.glb()), "--report", "-"});
    const Json report = Json::parse(result.out);
    ASSERT_EQ(report["warnings"].size(), 1u);
    EXPECT_NE(result.err.find(report["warnings"][0].get<std::string>()), std::string::npos);
}

TEST_F(Report, PackingTwiceGivesTheSameFile) {
    packReport();
    const Bytes first = readFile(output_);
    packReport();
    EXPECT_EQ(readFile(output_), first);
}

} // namespace edgeshade::test
