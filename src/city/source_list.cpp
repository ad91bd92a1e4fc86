#include "src/city/source_list.hpp"

#include "preprocess/base/error.hpp"
#include "src/city/gltf_tile.hpp"
#include "src/city/tileset.hpp"

#include <algorithm>

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

void add(const fs::path& path, SourceList& list) {
    const std::optional<SourceKind> kind = kindOf(path);
    if (kind) list.sources.push_back({path.filename().string(), *kind, eastNorthUpFromGltf});
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
            if (entry.is_regular_file(error)) add(entry.path(), list);
    } else {
        add(input, list);
    }
    if (list.sources.empty())
        throw InputError("'" + input.string() +
                         "' has no tile of a city: no .json or .jsonl of CityJSON, tileset.json, "
                         ".glb, .gltf, .tif or .tiff.");
    std::ranges::stable_sort(list.sources, {}, &Source::file);
    return list;
}

} // namespace edgeshade::city
