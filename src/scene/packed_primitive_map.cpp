#include "src/scene/packed_primitive_map.hpp"

namespace edgeshade {
namespace {

void addPairs(const std::vector<glm::vec2>& pairs, std::vector<glm::vec4>& texels) {
    for (std::size_t i = 0; i < pairs.size(); i += 2)
        texels.emplace_back(pairs[i], i + 1 < pairs.size() ? pairs[i + 1] : glm::vec2(0.0f));
}

} // namespace

PackedPrimitiveMap packedPrimitiveMap(const PrimitiveMap& map) {
    PackedPrimitiveMap packed{
        kindOf(map.tiles), map.tiles.mapFromWorld, map.size, map.longestList, {}, 0, {}};
    packed.texels.reserve((map.header.size() + map.entries.size()) / 2 + 2 + map.records.size());
    addPairs(map.header, packed.texels);
    packed.begins[0] = packed.texels.size();
    addPairs(map.entries, packed.texels);
    packed.begins[1] = packed.texels.size();
    packed.texels.insert(packed.texels.end(), map.records.begin(), map.records.end());
    packed.count = packed.texels.size();
    return packed;
}

} // namespace edgeshade
