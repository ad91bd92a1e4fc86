#include "src/hours/surfaces/html_report.hpp"

#include "src/hours/surfaces/division.hpp"
#include "src/hours/surfaces/surface_report.hpp"
#include "tests/support/scene_builder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::hours {
namespace {

/// A box of 2 x 2 x 2 in cells of 1, all lit in one position of six.
struct BoxRun {
    SurfaceRun run;
    std::vector<WorldTriangle> scene;
};

BoxRun boxRun() {
    BoxRun made;
    Scene scene = test::SceneBuilder().box({-1, 0, -1}, {1, 2, 1}).scene();
    scene.batches[0].placedBy = 0;
    const auto all = [](std::uint32_t, std::uint32_t) { return true; };
    made.scene = worldTriangles(scene, all);
    SurfaceRun& run = made.run;
    run.cells = cellsOf(scene, all, {1.0, 0.0});
    run.nodes[0] = "<box> & \"co\"";
    run.materials[0] = "brick";
    run.step = std::chrono::minutes(60);
    run.version = "1.2.3";
    run.files = {{{"name", "box.glb"}, {"sha256", std::string(64, 'a')}}};
    run.warnings = {"It is <dark>."};
    for (int hour = 8; hour < 14; ++hour)
        run.positions.push_back(
            {sun::localTimeFromText("2026-03-21T08:30Z").instant + std::chrono::hours(hour - 8), 0,
             0, glm::normalize(glm::dvec3(0, 1, 1))});
    run.light = lightOf(
        run.cells, {.positions = run.positions, .step = run.step, .bits = true},
        [](std::span<const Sensor> sensors, std::span<const glm::dvec3> directions) {
            rays::LitBits bits(sensors.size(), directions.size());
            for (std::size_t s = 0; s < sensors.size(); ++s)
                bits.setLit(s, 0);
            return bits;
        },
        [](double) {});
    run.settings = {{"file", "box.glb"}, {"from", "2026-03-21"}, {"to", "2026-03-21"},
                    {"step", 60},        {"utc-offset", "Z"},    {"place", {48.0, 11.0}},
                    {"threshold", 1.0}};
    return made;
}

std::string pageOf(const BoxRun& made) {
    const nlohmann::ordered_json json = made.run.settings;
    const HoursSettings settings = hoursSettings(JsonField("run", json, "settings"));
    return htmlOf(made.run, settings, surfaceReportOf(made.run, settings), made.scene,
                  {[](double share) { return share > 0.1 ? 0xFF0000u : 0x0000FFu; }, 6.0});
}

} // namespace

TEST(CellsPicture, ShowsCellsThatFaceTheEye) {
    const BoxRun made = boxRun();
    const glm::dvec3 eye = glm::normalize(glm::dvec3(1, 1, 1));
    const CellsPicture picture = pictureOf(
        made.run, made.scene,
        [&](std::size_t i) {
            return made.run.cells.cells[i].normal.y > 0.5 ? 0xFF0000u : 0x00FF00u;
        },
        eye, 300, 200);
    ASSERT_EQ(picture.rgba.size(), 4u * 300 * 200);
    const auto at = [&](double x, double y) {
        const std::size_t i = 4 * (static_cast<std::size_t>(y) * 300 + static_cast<std::size_t>(x));
        return std::array{picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
    };
    EXPECT_EQ(at(0, 0), (std::array<std::uint8_t, 3>{255, 255, 255}));
    std::size_t seen = 0;
    for (std::size_t i = 0; i < made.run.cells.cells.size(); ++i) {
        const Cell& cell = made.run.cells.cells[i];
        ASSERT_EQ(picture.places[i].has_value(), glm::dot(cell.normal, eye) > 0.0);
        if (!picture.places[i]) continue;
        ++seen;
        const auto color = at(picture.places[i]->x, picture.places[i]->y);
        EXPECT_EQ(color, (cell.normal.y > 0.5 ? std::array<std::uint8_t, 3>{255, 0, 0}
                                              : std::array<std::uint8_t, 3>{0, 255, 0}));
    }
    EXPECT_EQ(seen, 12u);
}

TEST(CellsPicture, HidesWhatIsBehind) {
    // A wall between the eye and the box's cells.
    BoxRun made = boxRun();
    made.scene.push_back({{-50, -50, 10}, {50, -50, 10}, {0, 80, 10}, 0, 0, 0, 0});
    const CellsPicture picture = pictureOf(
        made.run, made.scene, [](std::size_t) { return 0xFF0000u; }, {0, 0, 1}, 100, 100);
    for (const auto& place : picture.places)
        EXPECT_FALSE(place.has_value());
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        EXPECT_EQ(picture.rgba[i], picture.rgba[i + 1]);
}

TEST(HtmlReport, IsOnePageWithAllThatARunNeeds) {
    const std::string page = pageOf(boxRun());
    for (const char* word :
         {"<!DOCTYPE html>", "2026-03-21", "edgeshade 1.2.3", "SHA-256",
          "&lt;box&gt; &amp; &quot;co&quot;", "It is &lt;dark&gt;.", "data:image/png;base64,",
          "From the south-west", "area above threshold", "linear-gradient", "</html>"})
        EXPECT_NE(page.find(word), std::string::npos) << word;
    EXPECT_EQ(page.find("<box>"), std::string::npos);
    // Nothing is fetched from elsewhere.
    for (const char* word : {"<script", "<link", "src=", "url(", "href=\"http"})
        EXPECT_EQ(page.find(word), std::string::npos) << word;
    EXPECT_EQ(page.find("direct beam"), std::string::npos);
}

TEST(HtmlReport, SaysWhichWindowsPass) {
    BoxRun made = boxRun();
    made.run.ofWindows = true;
    std::string page = pageOf(made);
    EXPECT_NE(page.find("24 of 24 windows pass"), std::string::npos);
    EXPECT_NE(page.find("08:00–09:00"), std::string::npos);
    EXPECT_NE(page.find("&quot;co&quot;, 24"), std::string::npos);
    EXPECT_EQ(page.find(">fail<"), std::string::npos);
    made.run.settings["threshold"] = 1.5;
    page = pageOf(made);
    EXPECT_NE(page.find("0 of 24 windows pass"), std::string::npos);
    EXPECT_NE(page.find(">fail<"), std::string::npos);
}

TEST(RuleChecks, OfGardensNeedHalfOfTheArea) {
    BoxRun made = boxRun();
    made.run.settings["preset"] = "bre-garden";
    made.run.settings["threshold"] = 2.0;
    const auto rule = [&] {
        const nlohmann::ordered_json json = made.run.settings;
        const HoursSettings settings = hoursSettings(JsonField("run", json, "settings"));
        return surfaceReportOf(made.run, settings)["rule"];
    };
    EXPECT_EQ(rule()["of"], "gardens");
    EXPECT_EQ(rule()["passes"], false);
    for (std::size_t i = 0; i < 12; ++i)
        made.run.light.lit[i] = 2;
    EXPECT_EQ(rule()["checks"][0]["area_above_threshold_percent"], 50.0);
    EXPECT_EQ(rule()["passes"], true);
    made.run.light.lit[0] = 1;
    EXPECT_EQ(rule()["passes"], false);
    // A cell that is left out changes the whole.
    made.run.cells.cells[0].state = made.run.cells.cells[20].state = CellState::inside;
    EXPECT_EQ(rule()["passes"], true);
}

} // namespace edgeshade::hours
