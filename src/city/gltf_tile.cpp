#include "src/city/gltf_tile.hpp"

#include "preprocess/gltf/json_vectors.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/reading/scene_names.hpp"
#include "src/city/tile_writer.hpp"

#include <map>
#include <string_view>

namespace edgeshade::city {
namespace {

constexpr std::size_t b3dmHeader = 28;

} // namespace

CityTile tileFromGltf(const GltfDocument& document, const glm::dmat4& frameFromGltf) {
    CityTile tile;
    TileWriter writer(tile);
    const Scene scene = flattenScene(document, 0.0, {}, InstanceChoice::repeated);
    tile.warnings = scene.warnings.sentences();
    struct NodeObject {
        std::uint32_t number;
        std::string where;
    };
    std::map<int, NodeObject> objects; // by node
    const auto objectOf = [&](int node) -> const NodeObject& {
        const auto found = objects.find(node);
        if (found != objects.end()) return found->second;
        const std::string title =
            node < 0 ? "the scene" : nodeTitle(document, static_cast<std::size_t>(node));
        return objects
            .emplace(node, NodeObject{writer.addObject(title, true), document.where(title)})
            .first->second;
    };
    for (const Batch& batch : scene.batches) {
        if (batch.hidden) continue;
        const Geometry& geometry = *batch.geometry;
        const glm::dmat4 frameFromBatch = frameFromGltf * batch.worldFromBatch;
        for (std::uint32_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
            const NodeObject& object = objectOf(nodeOf(geometry, batch.placedBy, i));
            std::array<glm::dvec3, 3> corners;
            for (std::uint32_t c = 0; c < 3; ++c)
                corners[c] = glm::dvec3(
                    frameFromBatch * glm::dvec4(geometry.positions[geometry.indices[i + c]], 1.0));
            writer.addTriangle(corners, object.number, SurfaceKind::none, object.where);
        }
    }
    return tile;
}

std::span<const std::uint8_t> glbOfB3dm(std::span<const std::uint8_t> bytes,
                                        const std::filesystem::path& path, glm::dvec3& relativeTo) {
    const auto fail = [&](const std::string& what) -> InputError {
        return InputError("'" + path.string() + "' is not a b3dm of 3D Tiles: " + what + ".");
    };
    const auto number = [&](std::size_t at) {
        return std::uint64_t{bytes[at]} | std::uint64_t{bytes[at + 1]} << 8 |
               std::uint64_t{bytes[at + 2]} << 16 | std::uint64_t{bytes[at + 3]} << 24;
    };
    if (bytes.size() < b3dmHeader ||
        std::string_view(reinterpret_cast<const char*>(bytes.data()), 4) != "b3dm")
        throw fail("it does not begin with 'b3dm' and a header of 28 bytes");
    const std::uint64_t length = number(8), features = number(12);
    const std::uint64_t start = b3dmHeader + features + number(16) + number(20) + number(24);
    if (length > bytes.size() || start > length)
        throw fail("its header asks for " + std::to_string(std::max(length, start)) +
                   " bytes, but it has " + std::to_string(bytes.size()));
    if (features > 0) {
        const auto json = withJsonErrors(path, [&] {
            return nlohmann::ordered_json::parse(bytes.begin() + b3dmHeader,
                                                 bytes.begin() + b3dmHeader +
                                                     static_cast<std::ptrdiff_t>(features));
        });
        const JsonField table(path, json, "featureTable");
        table.requireObject();
        table.ifPresent("RTC_CENTER",
                        [&](const JsonField& center) { relativeTo = vectorFrom(center); });
    }
    return bytes.subspan(start, length - start);
}

} // namespace edgeshade::city
