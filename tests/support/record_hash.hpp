#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace edgeshade::test {

/// FNV-1a, 64 bits, over 32-bit words.
class WordHash {
  public:
    void add(std::uint32_t word) { value_ = (value_ ^ word) * 0x100000001B3u; }
    void add(std::size_t number) {
        add(static_cast<std::uint32_t>(number));
        add(static_cast<std::uint32_t>(static_cast<std::uint64_t>(number) >> 32));
    }
    void add(float number) { add(glm::floatBitsToUint(number)); }
    void add(const Box& box) {
        for (glm::length_t axis = 0; axis < 3; ++axis) { // for floats: all of them
            add(static_cast<float>(box.low[axis]));
            add(static_cast<float>(box.high[axis]));
        }
    }
    void add(const RecordRange& range) {
        add(range.first);
        add(range.count);
    }
    /// For records that consist only of words.
    template <class Record>
    void addAll(const std::vector<Record>& records) {
        static_assert(sizeof(Record) % 4 == 0 && std::is_trivially_copyable_v<Record>);
        add(records.size());
        const auto* bytes = reinterpret_cast<const unsigned char*>(records.data());
        for (std::size_t i = 0; i < records.size() * sizeof(Record); i += 4) {
            std::uint32_t word = 0;
            std::memcpy(&word, bytes + i, 4);
            add(word);
        }
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xCBF29CE484222325u;
};

/// Hash of everything that welding and edge finding produce.
inline std::uint64_t hashOf(const WeldedMesh& mesh, const EdgeList& edges) {
    WordHash hash;
    hash.addAll(mesh.positions);
    hash.addAll(mesh.triangles);
    hash.addAll(mesh.source);
    hash.add(mesh.degenerate);
    hash.addAll(edges.edges);
    hash.addAll(edges.opposites);
    return hash.value();
}

/// Hash of all contents of records.
inline std::uint64_t hashOf(const PlanePairShadow& shadow) {
    WordHash hash;
    hash.addAll(shadow.pairs);
    hash.addAll(shadow.pairPlanes);
    hash.addAll(shadow.singles);
    hash.addAll(shadow.caps);
    hash.addAll(shadow.capTriangles);
    for (const MaterialCasters& group : shadow.groups) {
        hash.add(group.material);
        hash.add(group.firstCap);
        hash.add(group.capCount);
    }
    for (const ShadowCluster& cluster : shadow.clusters) {
        hash.add(cluster.bounds);
        hash.add(std::uint32_t{cluster.closed} + 2 * std::uint32_t{cluster.alphaTested});
        hash.add(cluster.components);
        hash.add(cluster.singleSided);
        for (const RecordRange& range :
             {cluster.pairs, cluster.singles, cluster.caps, cluster.groups, cluster.leaves})
            hash.add(range);
    }
    for (const Box& leaf : shadow.leaves)
        hash.add(leaf);
    for (const std::size_t count : {shadow.edges, shadow.flatPairs, shadow.flatEdges})
        hash.add(count);
    if (shadow.vertices) {
        hash.addAll(shadow.vertices->pairs);
        hash.addAll(shadow.vertices->singles);
        hash.addAll(shadow.singlePlanes);
        hash.addAll(shadow.vertices->caps);
    }
    return hash.value();
}

} // namespace edgeshade::test
