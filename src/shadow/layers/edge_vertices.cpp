#include "src/shadow/layers/edge_vertices.hpp"

#include <cstring>

namespace edgeshade {
namespace {

/// Numbers places, and remembers the last ones, by a table that the first levels of a cache hold.
/// Neighbouring records share their places.
class PlaceNumbers {
  public:
    explicit PlaceNumbers(std::vector<glm::vec3>& places) : places_(places) {}

    std::uint32_t of(const glm::vec3& place) {
        Bits bits;
        std::memcpy(bits.data(), &place, sizeof(place));
        Known& known = lately_[slotOf(bits)];
        if (known.bits != bits || known.number == none) {
            known = {bits, static_cast<std::uint32_t>(places_.size())};
            places_.push_back(place);
        }
        return known.number;
    }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    static constexpr int slots = 12; ///< the binary logarithm of their number

    using Bits = std::array<std::uint32_t, 3>;
    struct Known {
        Bits bits{};
        std::uint32_t number = none;
    };

    static std::size_t slotOf(const Bits& bits) {
        std::uint64_t hash = (std::uint64_t{bits[0]} << 32 | bits[1]) * 0x9E3779B97F4A7C15u;
        hash = (hash ^ (hash >> 32) ^ bits[2]) * 0xC2B2AE3D27D4EB4Fu;
        return static_cast<std::size_t>(hash >> (64 - slots));
    }

    std::vector<Known> lately_ = std::vector<Known>(std::size_t{1} << slots);
    std::vector<glm::vec3>& places_;
};

template <class Record>
void number(const std::vector<Record>& records, const RecordRange& range, PlaceNumbers& numbers,
            std::vector<EndNumbers>& ends) {
    for (std::uint32_t i = range.first; i < range.end(); ++i) {
        const std::uint32_t a = numbers.of(records[i].a);
        ends[i] = {a, numbers.of(records[i].b)};
    }
}

template <class Record>
void place(const std::vector<Record>& records, const std::vector<EndNumbers>& ends,
           std::vector<glm::vec3>& places) {
    for (std::size_t i = 0; i < records.size(); ++i) {
        places[ends[i][0]] = records[i].a;
        places[ends[i][1]] = records[i].b;
    }
}

} // namespace

EdgeVertices::EdgeVertices(const PlanePairShadow& shadow) {
    if (shadow.vertices) {
        pairs = shadow.vertices->pairs;
        singles = shadow.vertices->singles;
        places.resize(shadow.vertices->inBatch.size());
        place(shadow.pairs, pairs, places);
        place(shadow.singles, singles, places);
        return;
    }
    pairs.resize(shadow.pairs.size());
    singles.resize(shadow.singles.size());
    PlaceNumbers numbers(places);
    for (const ShadowCluster& cluster : shadow.clusters) {
        number(shadow.pairs, cluster.pairs, numbers, pairs);
        number(shadow.singles, cluster.singles, numbers, singles);
    }
}

} // namespace edgeshade
