#include "src/city/source_list.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/gltf_tile.hpp"
#include "src/city/tileset.hpp"

#include <algorithm>
#include <set>
#include <sstream>

namespace edgeshade::city {
namespace {

namespace fs = std::filesystem;

constexpr const char* tilesetName = "tileset.json";

std::optional<SourceKind> kindOf(const fs::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".json") return SourceKind::cityJson;
    if (ending == ".jsonl") return SourceKind::cityJsonSequence;
    if (ending == ".glb" || ending == ".gltf") return SourceKind::gltf;
    if (ending == ".tif" || ending == ".tiff") return SourceKind::raster;
    return std::nullopt;
}

/// Adds a file of the list's folder, unless its ending says that it is no tile.
bool add(const fs::path& file, SourceList& list) {
    const std::optional<SourceKind> kind = kindOf(file);
    if (kind) list.sources.push_back({file.generic_string(), *kind, eastNorthUpFromGltf});
    return kind.has_value();
}

/// Adds the tiles that a text file lists.
void addListed(const fs::path& path, const ReadingLimits& limits, SourceList& list) {
    const Bytes bytes = readFile(path, limits.fileBytes);
    std::istringstream lines(std::string(bytes.begin(), bytes.end()));
    std::set<fs::path> known;
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty() || line.starts_with('#')) continue;
        const auto fail = [&](const std::string& why) {
            throw InputError("'" + path.string() + "', line " + std::to_string(number) + ": '" +
                             line + "' " + why);
        };
        const fs::path file = fs::path(line).lexically_normal();
        std::error_code error;
        if (!staysInside(file)) fail("must be in the list's folder or below.");
        if (file.filename() == tilesetName) fail("is a tileset; plan it by itself.");
        if (!known.insert(file).second) fail("is listed twice.");
        if (!fs::is_regular_file(list.folder / file, error)) fail("isn't there.");
        if (!add(file, list)) fail("is no .json, .jsonl, .glb, .gltf, .tif or .tiff.");
    }
}

} // namespace

SourceList sourcesIn(const fs::path& input, const ReadingLimits& limits) {
    SourceList list;
    std::error_code error;
    const bool isFolder = fs::is_directory(input, error);
    list.folder = isFolder ? input : input.parent_path();
    const fs::path tileset = isFolder ? input / tilesetName : input;
    if (tileset.filename() == tilesetName && fs::exists(tileset, error)) {
        Tileset read = readTileset(list.folder, tilesetName, limits);
        list.sources = std::move(read.sources);
        list.place = read.place;
    } else if (isFolder) {
        for (const fs::directory_entry& entry : fs::directory_iterator(input, error))
            if (entry.is_regular_file(error)) add(entry.path().filename(), list);
    } else if (input.extension() == ".txt") {
        addListed(input, limits, list);
    } else {
        add(input.filename(), list);
    }
    if (list.sources.empty())
        throw InputError("'" + input.string() +
                         "' has no tile of a city: no .json or .jsonl of CityJSON, tileset.json, "
                         ".glb, .gltf, .tif or .tiff, nor a .txt that lists them.");
    std::ranges::stable_sort(list.sources, {}, &Source::file);
    return list;
}

} // namespace edgeshade::city
