#include "src/city/tileset.hpp"

#include "preprocess/gltf/json_vectors.hpp"
#include "src/city/byte_text.hpp"
#include "src/city/geodetic.hpp"
#include "src/city/gltf_tile.hpp"
#include "src/city/json_text.hpp"

namespace edgeshade::city {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Tilesets within tilesets.
constexpr int mostNested = 16;
/// Points farther than this from the origin are earth-centred, in metres.
constexpr double leastEarthRadius = 6.0e6;

glm::dmat4 transformOf(const JsonField& tile) {
    const auto transform = tile.find("transform");
    return transform ? matrixFrom(*transform) : glm::dmat4(1.0);
}

/// The middle of a tile's bounding volume in its own axes; that of a region in earth-centred ones.
glm::dvec3 middleOf(const JsonField& tile) {
    const JsonField volume = tile.member("boundingVolume");
    volume.requireObject();
    if (const auto region = volume.find("region")) {
        const std::vector<double> of = region->numbers(6);
        const double longitude = 0.5 * (of[0] + of[2]), latitude = 0.5 * (of[1] + of[3]);
        return ecefOf({glm::degrees(latitude), glm::degrees(longitude)}, 0.5 * (of[4] + of[5]));
    }
    const auto box = volume.find("box");
    const auto sphere = volume.find("sphere");
    if (!box && !sphere) volume.fail(" is neither a box nor a sphere nor a region");
    const std::vector<double> of = box ? box->numbers(12) : sphere->numbers(4);
    return {of[0], of[1], of[2]};
}

class Walk {
  public:
    Walk(const fs::path& folder, const ReadingLimits& limits) : folder_(folder), limits_(limits) {}

    void read(const std::string& file, const glm::dmat4& above, int nested) {
        const fs::path path = folder_ / file;
        const Bytes bytes = readFile(path, limits_.fileBytes);
        const Json json =
            jsonFrom(city::textOf(bytes), "'" + path.string() + "' is not valid JSON");
        const JsonField root(path, json);
        root.requireObject();
        root.member("asset").member("version").oneOf({"1.0", "1.1"});
        const JsonField tile = root.member("root");
        tile.requireObject();
        if (nested == 0) findFrame(tile);
        readTile(tile, fs::path(file).parent_path(), above, false, nested, 0);
    }

    Tileset tileset;

  private:
    void findFrame(const JsonField& root) {
        const glm::dmat4 transform = transformOf(root);
        const bool isRegion = root.member("boundingVolume").find("region").has_value();
        glm::dvec3 origin(transform[3]);
        if (origin == glm::dvec3(0.0)) {
            origin = middleOf(root);
            if (!isRegion) origin = glm::dvec3(transform * glm::dvec4(origin, 1.0));
        }
        if (!(glm::length(origin) > leastEarthRadius)) return;
        tileset.place = placeOfEcef(origin);
        frameFromTiles_ = rigidInverse(ecefFromEastNorthUp(origin));
    }

    void readTile(const JsonField& tile, const fs::path& folder, const glm::dmat4& above, bool adds,
                  int nested, std::uint64_t depth) {
        tile.requireObject();
        // Tilesets may name each other many times over.
        if (++tiles_ > limits_.nodes)
            tile.fail(" is the tileset's tile " + std::to_string(tiles_) + ", but at most " +
                      std::to_string(limits_.nodes) + " are read");
        if (depth > limits_.nodeDepth)
            tile.fail(" is more than " + std::to_string(limits_.nodeDepth) + " levels deep");
        if (const auto implicit = tile.find("implicitTiling"))
            implicit->fail(" is there, but implicit tiling is not read: convert the tileset to "
                           "explicit tiles");
        tile.ifPresent("refine", [&](const JsonField& refine) {
            adds = refine.oneOf({"ADD", "REPLACE"}) == "ADD";
        });
        const glm::dmat4 frameFromTile = above * transformOf(tile);
        const bool isFinest = tile.countOf("children") == 0;
        const auto use = [&](const JsonField& content) {
            const auto uri = content.find("uri");
            readContent(uri ? *uri : content.member("url"), folder, frameFromTile, isFinest || adds,
                        nested);
        };
        tile.ifPresent("content", use);
        tile.ifPresent("contents", [&](const JsonField& contents) { contents.forEachItem(use); });
        tile.ifPresent("children", [&](const JsonField& children) {
            children.forEachItem([&](const JsonField& child) {
                readTile(child, folder, frameFromTile, adds, nested, depth + 1);
            });
        });
    }

    void readContent(const JsonField& uri, const fs::path& folder, const glm::dmat4& frameFromTile,
                     bool isUsed, int nested) {
        const std::string text = uri.text();
        const fs::path path = (folder / text).lexically_normal();
        if (text.empty() || text.find(':') != std::string::npos || !staysInside(path))
            uri.fail(" is '" + text + "', but must be a file in the tileset's folder");
        const std::string file = path.generic_string();
        const std::string ending = path.extension().string();
        if (ending == ".json") {
            if (nested == mostNested) uri.fail(" is more than 16 tilesets deep");
            read(file, frameFromTile, nested + 1);
            return;
        }
        const bool isGltf = ending == ".glb" || ending == ".gltf";
        if (!isGltf && ending != ".b3dm")
            uri.fail(" is '" + text + "', but content must be .glb, .gltf, .b3dm or .json");
        if (isUsed)
            tileset.sources.push_back({file, isGltf ? SourceKind::gltf : SourceKind::b3dm,
                                       frameFromTiles_ * frameFromTile * eastNorthUpFromGltf});
    }

    const fs::path& folder_;
    const ReadingLimits& limits_;
    glm::dmat4 frameFromTiles_{1.0};
    std::uint64_t tiles_ = 0; ///< read so far
};

} // namespace

Tileset readTileset(const std::filesystem::path& folder, const std::string& file,
                    const ReadingLimits& limits) {
    Walk walk(folder, limits);
    walk.read(file, glm::dmat4(1.0), 0);
    return std::move(walk.tileset);
}

} // namespace edgeshade::city
