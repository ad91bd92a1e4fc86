#include "src/hours/surfaces/bits_npy.hpp"
#include "src/hours/surfaces/cells_csv.hpp"
#include "src/hours/surfaces/cells_glb.hpp"
#include "src/hours/surfaces/division.hpp"
#include "src/hours/surfaces/surface_report.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/scene_builder.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <tiny_gltf.h>

namespace edgeshade::hours {
namespace {

using test::SceneBuilder;

/// A run of three hours over a wall of 1 x 1 and a far-off floor of 1 x 1 in cells of 0.5; the
/// first cell is dark, and the second has one hour.
SurfaceRun smallRun() {
    SurfaceRun run;
    Scene scene = SceneBuilder()
                      .quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})
                      .material(Material())
                      .quad({0, 0, 5}, {1, 0, 5}, {1, 0, 4}, {0, 0, 4})
                      .placedBy(glm::translate(glm::dmat4(1.0), glm::dvec3(4.5e6, 0.0, 5.4e6)))
                      .scene();
    scene.batches[0].placedBy = 3;
    run.cells = cellsOf(scene, [](std::uint32_t, std::uint32_t) { return true; }, {0.5, 0.0});
    run.nodes[3] = "wall, \"north\"";
    run.materials = {{0, "brick"}, {1, "grass"}};
    run.step = std::chrono::minutes(60);
    run.offset = std::chrono::minutes(60);
    for (const char* time : {"2026-03-21T08:30Z", "2026-03-21T09:30Z", "2026-03-21T10:30Z"})
        run.positions.push_back(
            {sun::localTimeFromText(time).instant, 0, 0, glm::normalize(glm::dvec3(0, 1, 1))});
    run.light = lightOf(
        run.cells, {.positions = run.positions, .step = run.step, .bits = true},
        [](std::span<const Sensor> sensors, std::span<const glm::dvec3> directions) {
            rays::LitBits bits(sensors.size(), directions.size());
            for (std::size_t s = 1; s < sensors.size(); ++s)
                for (std::size_t d = 0; d < (s == 1 ? 1 : directions.size()); ++d)
                    bits.setLit(s, d);
            return bits;
        },
        [](double) {});
    run.settings = {{"file", "wall.glb"}, {"from", "2026-03-21"},   {"to", "2026-03-21"},
                    {"step", 60},         {"utc-offset", "+01:00"}, {"place", {48.0, 11.0}},
                    {"threshold", 1.0}};
    return run;
}

tinygltf::Model readBack(const Bytes& glb) {
    tinygltf::Model model;
    tinygltf::TinyGLTF reader;
    std::string error, warning;
    EXPECT_TRUE(reader.LoadBinaryFromMemory(&model, &error, &warning, glb.data(),
                                            static_cast<unsigned>(glb.size())))
        << error;
    EXPECT_EQ(error + warning, "");
    return model;
}

/// An accessor's values, each component as a double; checks that they are within the buffer.
std::vector<double> valuesOf(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
    const tinygltf::BufferView& view =
        model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    const std::vector<unsigned char>& bytes = model.buffers.at(0).data;
    const auto size = static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
    const auto components = static_cast<std::size_t>(
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
    EXPECT_EQ(accessor.byteOffset, 0u);
    EXPECT_EQ(view.byteOffset % size, 0u);
    EXPECT_EQ(view.byteLength, accessor.count * components * size);
    EXPECT_LE(view.byteOffset + view.byteLength, bytes.size());
    std::vector<double> values;
    for (std::size_t i = 0; i < accessor.count * components; ++i) {
        const unsigned char* at = bytes.data() + view.byteOffset + i * size;
        if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT) {
            float value;
            std::memcpy(&value, at, sizeof value);
            values.push_back(value);
        } else if (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
            std::uint16_t value;
            std::memcpy(&value, at, sizeof value);
            values.push_back(value / 65535.0);
        } else {
            std::uint32_t value;
            std::memcpy(&value, at, sizeof value);
            values.push_back(value);
        }
    }
    return values;
}

} // namespace

TEST(SurfaceFiles, TheMeshIsReadBackByTinygltf) {
    const SurfaceRun run = smallRun();
    const tinygltf::Model model = readBack(glbOf(
        run, [](double share) { return glm::dvec3(share, 0.5, 0.0); }, 3.0));
    ASSERT_EQ(model.nodes.size(), 1u);
    EXPECT_EQ(model.nodes[0].name, "wall, \"north\"");
    // Far-off places stay exact: floats are relative to the node.
    EXPECT_NEAR(model.nodes[0].translation[0], 4.5e6 + 0.5, 1e-9);
    const tinygltf::Primitive& primitive = model.meshes.at(0).primitives.at(0);
    const std::vector<double> positions = valuesOf(model, primitive.attributes.at("POSITION")),
                              normals = valuesOf(model, primitive.attributes.at("NORMAL")),
                              colors = valuesOf(model, primitive.attributes.at("COLOR_0")),
                              hours = valuesOf(model, primitive.attributes.at("_HOURS")),
                              indices = valuesOf(model, primitive.indices);
    ASSERT_EQ(positions.size(), 3 * hours.size());
    ASSERT_EQ(normals.size(), positions.size());
    ASSERT_EQ(colors.size(), 4 * hours.size());
    const tinygltf::Accessor& accessor =
        model.accessors[static_cast<std::size_t>(primitive.attributes.at("POSITION"))];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = 1e9, high = -1e9;
        for (std::size_t i = axis; i < positions.size(); i += 3) {
            low = std::min(low, positions[i]);
            high = std::max(high, positions[i]);
        }
        EXPECT_EQ(accessor.minValues.at(axis), low);
        EXPECT_EQ(accessor.maxValues.at(axis), high);
    }
    double area = 0.0, weighted = 0.0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::array<glm::dvec3, 3> corner;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto v = static_cast<std::size_t>(indices[i + c]);
            ASSERT_LT(v, hours.size());
            corner[c] = {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
            EXPECT_NEAR(colors[4 * v], hours[v] / 3.0, 1e-4);
        }
        const auto v = static_cast<std::size_t>(indices[i]);
        const glm::dvec3 cross = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        EXPECT_GT(glm::dot(cross, {normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]}), 0.0);
        area += 0.5 * glm::length(cross);
        weighted += 0.5 * glm::length(cross) * hours[v];
    }
    EXPECT_NEAR(area, 2.0, 1e-6);
    EXPECT_NEAR(weighted, 0.25 * (0.0 + 1.0 + 6 * 3.0), 1e-6);
}

TEST(SurfaceFiles, CellsLeftOutAreGrey) {
    SurfaceRun run = smallRun();
    for (Cell& cell : run.cells.cells)
        cell.state = CellState::inside;
    const tinygltf::Model model = readBack(glbOf(
        run, [](double) { return glm::dvec3(1.0, 0.0, 0.0); }, 3.0));
    const std::vector<double> colors =
        valuesOf(model, model.meshes.at(0).primitives.at(0).attributes.at("COLOR_0"));
    for (std::size_t i = 0; i < colors.size(); ++i)
        EXPECT_NEAR(colors[i], i % 4 == 3 ? 1.0 : 0.2, 1e-4);
}

TEST(SurfaceFiles, TheTableHasALineACell) {
    const SurfaceRun run = smallRun();
    const std::string csv = csvOf(run, {.when = true});
    std::vector<std::string> lines;
    std::istringstream text(csv);
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    ASSERT_EQ(lines.size(), 1u + 8u);
    EXPECT_EQ(lines[0], "x,y,z,nx,ny,nz,area_m2,hours,node,material,node_index,material_index,"
                        "left_out,first,last");
    EXPECT_TRUE(lines[1].ends_with(",0,0,1,0.25,0,\"wall, \"\"north\"\"\",brick,3,0,,,"))
        << lines[1];
    EXPECT_TRUE(lines[2].ends_with("brick,3,0,,2026-03-21T09:00+01:00,2026-03-21T10:00+01:00"))
        << lines[2];
    EXPECT_TRUE(lines[8].ends_with("grass,3,1,,2026-03-21T09:00+01:00,2026-03-21T12:00+01:00"))
        << lines[8];
}

TEST(SurfaceFiles, BitsHaveNumPysHeader) {
    const SurfaceRun run = smallRun();
    const Bytes npy = npyOf(run);
    ASSERT_EQ(npy.size(), 128u + 8u);
    EXPECT_EQ(std::string(npy.begin(), npy.begin() + 8), std::string("\x93NUMPY\x01\0", 8));
    EXPECT_EQ(npy[8] + 256 * npy[9], 118);
    EXPECT_EQ(npy[127], '\n');
    EXPECT_EQ(npy[128], 0b0000'0000);
    EXPECT_EQ(npy[129], 0b1000'0000);
    EXPECT_EQ(npy[135], 0b1110'0000);
}

TEST(SurfaceReport, WeighsByAreaAndLeavesOut) {
    SurfaceRun run = smallRun();
    run.unit = 2.0; // a cell of 0.25 has a square metre
    run.cells.cells[7].state = CellState::inside;
    run.cells.cells[6].state = CellState::within;
    const nlohmann::ordered_json settings = run.settings;
    const nlohmann::ordered_json report =
        surfaceReportOf(run, hoursSettings(JsonField("run", settings, "settings")));
    EXPECT_EQ(report["cells"], 8);
    EXPECT_EQ(report["inside_solids"]["cells"], 1);
    EXPECT_EQ(report["within_others"]["cells"], 1);
    EXPECT_NEAR(report["inside_solids"]["area"].get<double>(), 1.0, 1e-9);
    EXPECT_NEAR(report["area"].get<double>(), 6.0, 1e-9);
    EXPECT_NEAR(report["hours"]["mean"].get<double>(), (1.0 + 4 * 3.0) / 6.0, 1e-9);
    EXPECT_EQ(report["hours"]["min"], 0.0);
    EXPECT_NEAR(report["area_above_threshold_percent"].get<double>(), 100.0 * 5 / 6, 1e-9);
    ASSERT_EQ(report["by_material"].size(), 2u);
    EXPECT_EQ(report["by_material"][0]["name"], "brick");
    EXPECT_EQ(report["by_material"][0]["cells"], 4);
    EXPECT_NEAR(report["by_material"][1]["area"].get<double>(), 2.0, 1e-9);
    EXPECT_EQ(report["by_node"].size(), 1u);
    ASSERT_EQ(report["histogram"].size(), 3u);
    EXPECT_NEAR(report["histogram"][0]["area"].get<double>(), 1.0, 1e-9);
    EXPECT_NEAR(report["histogram"][2]["area"].get<double>(), 4.0, 1e-9);
}

} // namespace edgeshade::hours
