// CityJSON: levels of detail, parts, semantics, holes, and broken files.

#include "src/city/city_json.hpp"
#include "tests/support/input_error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace edgeshade::city {
namespace {

using Json = nlohmann::ordered_json;

/// A building at two levels of detail, 10 by 10 m at 1 and 4 by 4 with a hole of 2 by 2 at 2.2,
/// which a part of it has.
Json town() {
    Json json = Json::parse(R"({
        "type": "CityJSON", "version": "1.1",
        "transform": {"scale": [0.5, 0.5, 0.5], "translate": [1000, 2000, 100]},
        "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"},
        "CityObjects": {
            "tower": {"type": "Building", "children": ["part"], "geometry": [
                {"type": "MultiSurface", "lod": "1", "boundaries": [[[0, 1, 2, 3]]]}]},
            "part": {"type": "BuildingPart", "parents": ["tower"], "geometry": [
                {"type": "MultiSurface", "lod": "2.2", "boundaries": [[[4, 5, 6, 7], [8, 9, 10, 11]]],
                 "semantics": {"surfaces": [{"type": "RoofSurface"}], "values": [0]}}]}},
        "vertices": [[0,0,0], [20,0,0], [20,20,0], [0,20,0], [0,0,8], [8,0,8], [8,8,8], [0,8,8],
                     [2,2,8], [2,6,8], [6,6,8], [6,2,8]]})");
    return json;
}

CityTile read(const Json& json, std::optional<double> lod = std::nullopt) {
    const std::string text = json.dump();
    return tileFromCityJson(Bytes(text.begin(), text.end()), "a.city.json", false, lod);
}

double areaOf(const CityTile& tile, SurfaceKind kind) {
    double area = 0.0;
    for (const CityTriangle& triangle : tile.triangles)
        if (triangle.kind == kind)
            area += 0.5 * glm::length(glm::cross(triangle.corners[1] - triangle.corners[0],
                                                 triangle.corners[2] - triangle.corners[0]));
    return area;
}

TEST(CityJson, HasHolesSemanticsPartsAndACode) {
    const CityTile tile = read(town());
    EXPECT_EQ(tile.epsg, 7415);
    EXPECT_EQ(areaOf(tile, SurfaceKind::roof), 12.0);
    EXPECT_EQ(areaOf(tile, SurfaceKind::none), 100.0);
    ASSERT_EQ(tile.objects.size(), 1u);
    EXPECT_EQ(tile.objects[0].id, "tower");
    EXPECT_TRUE(tile.objects[0].isBuilding);
    EXPECT_EQ(tile.triangles[0].corners[0].z, 100.0);
}

TEST(CityJson, LevelsOfDetailAreChosen) {
    const CityTile coarse = read(town(), 1.0);
    EXPECT_EQ(areaOf(coarse, SurfaceKind::roof), 0.0);
    EXPECT_EQ(areaOf(coarse, SurfaceKind::none), 100.0);
    ASSERT_EQ(coarse.warnings.size(), 1u);
    Json two = town();
    Json fine = two["CityObjects"]["part"]["geometry"][0];
    two["CityObjects"]["tower"]["geometry"].push_back(fine);
    EXPECT_EQ(areaOf(read(two), SurfaceKind::none), 0.0);
    EXPECT_EQ(areaOf(read(two), SurfaceKind::roof), 24.0);
}

TEST(CityJson, FaultsNameTheField) {
    const auto expect = [](const char* pointer, const Json& value,
                           std::initializer_list<const char*> words) {
        Json json = town();
        json[Json::json_pointer(pointer)] = value;
        test::expectInputError([&] { read(json); }, words);
    };
    expect("/type", "City", {"'a.city.json': type", "'City'"});
    expect("/version", "3.0", {"version", "3.0"});
    expect("/transform/scale", 2, {"transform.scale"});
    expect("/metadata/referenceSystem", "here", {"metadata.referenceSystem", "'here'"});
    expect("/vertices/3", Json::array({1, 2}), {"vertices[3]", "three numbers"});
    expect("/vertices/3/0", 1.5, {"vertices[3][0]"});
    expect("/CityObjects/tower/geometry/0/boundaries/0/0/2", 12,
           {"CityObjects.tower.geometry[0].boundaries[0][0][2]", "12"});
    expect("/CityObjects/tower/geometry/0/lod", "fine", {"lod", "'fine'"});
    expect("/CityObjects/part/parents/0", "nobody", {"CityObjects.part", "'nobody'"});
    expect("/CityObjects/part/geometry/0/semantics/values/0", 4, {"semantics 4"});
    expect("/transform/translate/0", 1e12, {"boundaries[0]", "2^29"});
    expect("/transform/scale/0", 1e4, {"boundaries[0]", "8192"});
    Json cycle = town();
    cycle["CityObjects"]["tower"]["parents"] = {"part"};
    test::expectInputError([&] { read(cycle); }, {"not above it"});
}

TEST(CityJson, SequencesNameTheLine) {
    Json header = town();
    header["CityObjects"] = Json::object();
    header["vertices"] = Json::array();
    Json feature = town();
    feature["type"] = "CityJSONFeature";
    const auto readText = [](const std::string& text) {
        return tileFromCityJson(Bytes(text.begin(), text.end()), "a.city.jsonl", true, {});
    };
    EXPECT_EQ(areaOf(readText(header.dump() + "\n" + feature.dump() + "\n"), SurfaceKind::roof),
              12.0);
    EXPECT_EQ(areaOf(readText("\n" + header.dump() + "\n" + feature.dump()), SurfaceKind::roof),
              12.0);
    test::expectInputError([&] { readText("\n" + feature.dump()); }, {"line 2.type", "'CityJSON'"});
    test::expectInputError([&] { readText("\n \n"); }, {"is empty"});
    test::expectInputError([&] { readText(header.dump() + "\n{"); }, {"line 2", "not valid JSON"});
    test::expectInputError([&] { readText(header.dump() + "\n\n" + header.dump()); },
                           {"line 3.type", "CityJSONFeature"});
}

} // namespace
} // namespace edgeshade::city
