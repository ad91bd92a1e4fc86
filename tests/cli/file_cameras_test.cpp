// --camera: the file's cameras in render, compare, bench and info.
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// A box and two cameras at (0, 0.5, 6) that look along -z.
class FileCameras : public testing::Test {
  protected:
    FileCameras() {
        GltfBuilder gltf;
        gltf.addShapeNode(box(glm::vec3(1.0f)));
        gltf.json["cameras"] = {
            {{"type", "perspective"},
             {"name", "wide"},
             {"perspective", {{"yfov", 2.0 * std::atan(0.5)}, {"znear", 0.1}}}},
            {{"type", "orthographic"},
             {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}}};
        gltf.addNode({{"camera", 0}, {"translation", {0, 0.5, 6}}, {"scale", {-2, 2, 2}}});
        gltf.addNode({{"camera", 1}, {"name", "plan"}, {"translation", {0, 0.5, 6}}});
        file_ = folder_.write("scene.glb", gltf.glb());
    }

    ProcessResult render(const std::vector<std::string>& more, const std::string& file = "") {
        std::vector<std::string> arguments = {"render", file.empty() ? file_ : file,
                                              folder_ / "out.png", "--size", "96x64"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runEdgeshade(arguments);
    }

    Bytes picture(const std::vector<std::string>& more) {
        const ProcessResult result = render(more);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.status == 0 ? readFile(folder_ / "out.png") : Bytes();
    }

    TempFolder folder_;
    std::string file_;
};

const std::string matrix = "1,0,0,0,0,1,0,0,0,0,1,0,0,-0.5,-6,1";
const std::string fov = std::to_string(2.0 * std::atan(0.5) * 180.0 / M_PI);

} // namespace

TEST_F(FileCameras, DrawWhatTheirMatricesDraw) {
    const Bytes wide = picture({"--camera", "wide"});
    EXPECT_EQ(wide, picture({"--camera", "0"}));
    EXPECT_EQ(wide, picture({"--camera-matrix", matrix, "--fov", fov}));
    const Bytes plan = picture({"--camera", "plan"});
    EXPECT_EQ(plan, picture({"--camera", "1"}));
    EXPECT_EQ(plan, picture({"--camera-matrix", matrix, "--ortho", "4"}));
    EXPECT_NE(plan, wide);
}

TEST_F(FileCameras, TheDefaultOneIsBeforeWhatPointsAtIt) {
    const glm::vec3 towards = glm::normalize(glm::vec3(0.55f, 0.45f, 1.0f)); // the eye
    const glm::vec3 aside(0.01f, 0.0f, 0.0f), up(0.0f, 0.01f, 0.0f);
    const std::vector<std::vector<glm::vec3>> scenes = {
        {towards, -towards + aside, -towards + up},
        {towards, -towards + 30.0f * aside, -towards},
        {towards, towards - 0.1f * aside, -3.0f * towards + 60.0f * aside}};
    for (const std::vector<glm::vec3>& corners : scenes) {
        Shape shape;
        shape.positions = corners;
        shape.indices = {0, 1, 2, 0, 2, 1};
        GltfBuilder gltf;
        gltf.addShapeNode(shape);
        const ProcessResult result =
            render({"--report", folder_ / "report.json"}, folder_.write("needle.glb", gltf.glb()));
        ASSERT_EQ(result.status, 0) << result.err;
        const Bytes bytes = readFile(folder_ / "report.json");
        const Json camera = Json::parse(bytes.begin(), bytes.end())["camera"];
        const auto point = [&](const char* key) {
            return glm::dvec3(camera[key][0], camera[key][1], camera[key][2]);
        };
        const glm::dvec3 ahead = glm::normalize(point("to") - point("from"));
        const Json bounds = boundsOf(corners);
        double diagonal = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            diagonal +=
                std::pow(bounds["max"][c].get<double>() - bounds["min"][c].get<double>(), 2);
        diagonal = std::sqrt(diagonal);
        for (const glm::vec3& corner : corners)
            EXPECT_GE(glm::dot(glm::dvec3(corner) - point("from"), ahead), diagonal / 50.0);
        EXPECT_GE(camera["near"].get<double>(), diagonal / 100.0);
    }
}

TEST_F(FileCameras, AreInReports) {
    ASSERT_EQ(render({"--camera", "plan", "--report", folder_ / "report.json"}).status, 0);
    const Bytes bytes = readFile(folder_ / "report.json");
    const Json camera = Json::parse(bytes.begin(), bytes.end())["camera"];
    EXPECT_EQ(camera["node"], "plan");
    EXPECT_EQ(camera["ortho"], 4.0);
    EXPECT_EQ(camera["matrix"][14], -6.0);
}

TEST_F(FileCameras, AnUnknownOneListsThoseThereAre) {
    const ProcessResult result = render({"--camera", "front"});
    EXPECT_EQ(result.status, 1);
    for (const char* words : {"--camera", "'front'", "0 'wide'", "1 'plan'"})
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    GltfBuilder none;
    none.addShapeNode(box(glm::vec3(1.0f)));
    const ProcessResult without = render({"--camera", "0"}, folder_.write("none.glb", none.glb()));
    EXPECT_EQ(without.status, 1);
    EXPECT_NE(without.err.find("it has none"), std::string::npos) << without.err;
}

TEST_F(FileCameras, GoWithNoOtherCamera) {
    for (const std::vector<std::string>& other :
         {std::vector<std::string>{"--camera-from", "1,2,3"},
          {"--camera-to", "1,2,3"},
          {"--camera-matrix", matrix},
          {"--ortho", "3"},
          {"--fov", "30"}}) {
        std::vector<std::string> both = {"--camera", "wide"};
        both.insert(both.end(), other.begin(), other.end());
        const ProcessResult result = render(both);
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.err.find(other[0]), std::string::npos) << result.err;
    }
    const ProcessResult near = render({"--camera", "plan", "--near", "0.1"});
    EXPECT_EQ(near.status, 1);
    EXPECT_NE(near.err.find("--near"), std::string::npos) << near.err;
    EXPECT_EQ(runEdgeshade({"compare", file_, "--camera", "wide", "--views", "2"}).status, 1);
}

TEST_F(FileCameras, AreListedByInfo) {
    const ProcessResult result = runEdgeshade({"info", file_, "--report", folder_ / "info.json"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("camera 0"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("plan, orthographic, 4 scene units high"), std::string::npos)
        << result.out;
    const Bytes bytes = readFile(folder_ / "info.json");
    const Json cameras = Json::parse(bytes.begin(), bytes.end())["cameras"];
    ASSERT_EQ(cameras.size(), 2u);
    EXPECT_EQ(cameras[0]["name"], "wide");
    EXPECT_EQ(cameras[0]["from"], (Json{0.0, 0.5, 6.0}));
    EXPECT_EQ(cameras[0]["direction"], (Json{0.0, 0.0, -1.0}));
}

TEST_F(FileCameras, AreComparedAndMeasured) {
    for (const char* verb : {"compare", "bench"}) {
        std::vector<std::string> arguments = {
            verb,     file_,   "--camera", "plan",
            "--size", "64x48", "--report", folder_ / "report.json"};
        if (verb == std::string("bench")) arguments.insert(arguments.end(), {"--frames", "2"});
        const ProcessResult result = runEdgeshade(arguments);
        if (result.status == 3) continue; // built without the oracle
        EXPECT_EQ(result.status, 0) << result.err;
    }
}

} // namespace edgeshade::test
