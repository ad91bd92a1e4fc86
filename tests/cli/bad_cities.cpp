// Tiles of cities.
#include "tests/cli/bad_input.hpp"

namespace edgeshade::test {
namespace {

/// A sound CityJSON file: a roof of 8 by 8 m with a hole.
Json soundTile() {
    return Json::parse(R"({
        "type": "CityJSON", "version": "2.0",
        "transform": {"scale": [0.001, 0.001, 0.001], "translate": [0, 0, 0]},
        "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"},
        "CityObjects": {"b1": {"type": "Building", "geometry": [
            {"type": "MultiSurface", "lod": "2.2",
             "boundaries": [[[0, 1, 2, 3], [4, 5, 6, 7]]],
             "semantics": {"surfaces": [{"type": "RoofSurface"}], "values": [0]}}]}},
        "vertices": [[0, 0, 0], [8000, 0, 0], [8000, 8000, 0], [0, 8000, 0],
                     [2000, 2000, 0], [2000, 6000, 0], [6000, 6000, 0], [6000, 2000, 0]]})");
}

BadInput badTile(const std::string& name, const std::string& file, const std::string& text,
                 const std::vector<std::string>& words) {
    return {name,
            [=](const TempFolder& folder) { return folder.write(file, std::string_view(text)); },
            words,
            {"city-plan"},
            {"--place", "52,5", "--date", "2026-03-20"}};
}

/// The sound tile with another value at a JSON pointer.
BadInput badCityJson(const std::string& name, const char* pointer, const Json& value,
                     const std::vector<std::string>& words) {
    Json json = soundTile();
    json[Json::json_pointer(pointer)] = value;
    return badTile(name, "bad.city.json", json.dump(), words);
}

BadInput badTileset(const std::string& name, const std::string& root,
                    const std::vector<std::string>& words) {
    return badTile(name, "tileset.json",
                   R"({"asset": {"version": "1.1"}, "root": {"boundingVolume": {"sphere": )"
                   R"([0, 0, 0, 9]}, )" +
                       root + "}}",
                   words);
}

} // namespace

std::vector<BadInput> badCities() {
    return {
        badTile("CityTileIsCut", "bad.city.json", soundTile().dump().substr(0, 300),
                {"is not valid JSON"}),
        badTile("CityTileIsOtherJson", "bad.json", "{}", {"type is missing"}),
        badTile("CitySequenceIsCut", "bad.city.jsonl", "{\"type\": \"CityJSON\"", {"line 1"}),
        badTile("CityRasterIsNone", "bad.tif", "no raster", {"is not a TIFF"}),
        badTile("CityOfNothing", "bad.zip", "words", {"has no tile of a city"}),
        badTile("CityListNamesNoTile", "list.txt", "# tiles\n\nlist.txt\n",
                {"line 3", "'list.txt' is no .json"}),
        badTile("CityListNamesAMissingTile", "list.txt", "a.city.json", {"line 1", "isn't there"}),
        badTile("CityListIsOfElsewhere", "list.txt", "../a.city.json", {"line 1", "or below"}),
        badCityJson("CityJsonVersion", "/version", "1.0", {"version"}),
        badCityJson("CityJsonTransformOfTwo", "/transform/scale", {1, 1}, {"transform.scale"}),
        badCityJson("CityJsonVertexOfTwo", "/vertices/2", {1, 2}, {"vertices[2]"}),
        badCityJson("CityJsonVertexIsFractional", "/vertices/2/1", 0.5, {"vertices[2][1]"}),
        badCityJson("CityJsonVertexIsMissing", "/CityObjects/b1/geometry/0/boundaries/0/0/1", 8,
                    {"CityObjects.b1.geometry[0].boundaries[0][0][1]"}),
        badCityJson("CityJsonRingIsNumber", "/CityObjects/b1/geometry/0/boundaries/0/0", 3,
                    {"boundaries[0][0]"}),
        badCityJson("CityJsonSemanticsOutOfRange", "/CityObjects/b1/geometry/0/semantics/values/0",
                    7, {"semantics 7"}),
        badCityJson("CityJsonLodIsWord", "/CityObjects/b1/geometry/0/lod", "fine", {"lod"}),
        badCityJson("CityJsonParentIsMissing", "/CityObjects/b1/parents", Json::array({"b0"}),
                    {"b0"}),
        badCityJson("CityJsonCodeIsWord", "/metadata/referenceSystem", "RD", {"referenceSystem"}),
        badCityJson("CityJsonTooFar", "/transform/translate/1", 1e15, {"2^29"}),
        badCityJson("CityJsonTooLarge", "/transform/scale/0", 10.0, {"8192"}),
        badTileset("TilesetIsImplicit", R"("implicitTiling": {})", {"root.implicitTiling"}),
        badTileset("TilesetContentIsElsewhere", R"("content": {"uri": "../a.glb"})",
                   {"root.content.uri"}),
        badTileset("TilesetContentIsPoints", R"("content": {"uri": "a.pnts"})", {"a.pnts"}),
        badTileset("TilesetTransformOfTwo", R"("transform": [1, 2])", {"root.transform"}),
    };
}

} // namespace edgeshade::test
