#include "src/scene/packed_primitive_map.hpp"

#include <algorithm>
#include <utility>

namespace edgeshade {
namespace {

/// Adds a light's shape and points.
void addPlaces(const LightTiles& tiles, std::span<const Light> points,
               std::vector<glm::vec4>& texels) {
    const LightShape& shape = *tiles.shape;
    texels.emplace_back(shape.center);
    for (glm::length_t i = 0; i < 3; ++i)
        texels.emplace_back(glm::vec3(shape.arms[i]),
                            i == 0 ? static_cast<float>(points.size()) : 0.0f);
    for (std::size_t first = 0; first < points.size(); first += placesAtOnce) {
        std::array<std::array<glm::vec4, placesAtOnce / 4>, 4> numbers{}; // x, y, z, counted
        const std::size_t count = std::min(points.size() - first, placesAtOnce);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec4 place = tiles.mapFromWorld * points[first + i].position;
            for (std::size_t axis = 0; axis < 4; ++axis)
                numbers[axis][i / 4][static_cast<glm::length_t>(i % 4)] =
                    axis == 3 ? 1.0f : static_cast<float>(place[static_cast<glm::length_t>(axis)]);
        }
        for (const auto& of : numbers)
            texels.insert(texels.end(), of.begin(), of.end());
    }
}

} // namespace

PackedPrimitiveMap packedPrimitiveMap(PrimitiveMap map, std::span<const Light> points) {
    PackedPrimitiveMap packed;
    packed.kind = kindOf(map.tiles);
    packed.mapFromWorld = map.tiles.mapFromWorld;
    packed.size = map.size;
    packed.longestList = map.longestList;
    packed.begins = {map.entriesBegin(), map.recordsBegin()};
    packed.texels = std::move(map.texels);
    if (!points.empty()) {
        packed.places = packed.texels.size();
        packed.sixteens = (points.size() + placesAtOnce - 1) / placesAtOnce;
        addPlaces(map.tiles, points, packed.texels);
    }
    packed.count = packed.texels.size();
    return packed;
}

} // namespace edgeshade
