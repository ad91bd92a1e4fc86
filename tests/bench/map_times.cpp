// Processor time of building a resting light's map on one thread, as the worker of a page does, and
// a print of the map's texels, so that two builds can be compared. Needs no GL. `map_times
// SCENE...` prints JSON.
#include "preprocess/base/stopwatch.hpp"
#include "src/scene/fitting_map.hpp"
#include "src/scene/load.hpp"
#include "src/scene/packed_primitive_map.hpp"
#include "tests/bench/told_scenes.hpp"

#include <cstring>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// A map's settings in src/engine/lookup_work.cpp.
constexpr std::size_t mostBytes = std::size_t{64} << 20;

/// FNV-1a (G. Fowler, L. C. Noll and K.-P. Vo) of texels, eight bytes at a time.
std::uint64_t printOf(std::span<const glm::vec4> texels) {
    std::uint64_t print = 0xcbf29ce484222325u;
    for (const glm::vec4& texel : texels) {
        std::array<std::uint64_t, 2> halves{};
        static_assert(sizeof halves == sizeof texel);
        std::memcpy(halves.data(), &texel, sizeof texel);
        for (const std::uint64_t half : halves)
            print = (print ^ half) * 0x100000001b3u;
    }
    return print;
}

Json mapOf(const std::string& name, const std::vector<PlacedCasters>& casters, const Light& light,
           int size) {
    PrimitiveMapSettings settings;
    settings.size = size;
    settings.mostBytes = mostBytes;
    settings.othersReceive = true;
    Stopwatch watch;
    FittingMap fitting(light, casters, settings);
    while (fitting.step()) {
    }
    const double built = watch.lap();
    Json told{{"light", name}, {"build_ms", 1e3 * built}};
    if (!fitting.map()) return told;
    const PackedPrimitiveMap packed = packedPrimitiveMap(std::move(*fitting.map()));
    told["pack_ms"] = 1e3 * watch.lap();
    told["size"] = packed.size;
    told["bytes"] = packed.texels.size() * sizeof(glm::vec4);
    told["longest_list"] = packed.longestList;
    told["print"] = printOf(packed.texels);
    return told;
}

Json measured(const std::string& path) {
    const LoadedScene loaded = loadScene(path, std::nullopt);
    std::vector<PlacedCasters> casters;
    std::size_t triangles = 0;
    Stopwatch watch;
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i) {
        casters.push_back(
            {std::make_shared<const CasterEdges>(casterEdgesOf(*loaded.planePairs[i])),
             loaded.scene.batches[i].worldFromBatch, true});
        triangles += casters.back().casters->mesh.triangles.size();
    }
    const double edges = watch.lap();
    Light sun, lamp;
    sun.position = {0.5, 1.0, -0.3, 0.0};
    lamp.position = glm::dvec4(besideAndAbove(worldBounds(loaded.scene)), 1.0);
    return {{"scene", path},
            {"triangles", triangles},
            {"edges_ms", 1e3 * edges},
            {"maps", {mapOf("sun", casters, sun, 512), mapOf("lamp", casters, lamp, 512)}}};
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
