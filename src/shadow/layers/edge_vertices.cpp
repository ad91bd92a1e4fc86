#include "src/shadow/layers/edge_vertices.hpp"

#include <bit>
#include <cstring>

namespace edgeshade {
namespace {

/// Numbers places in the order in which they come: a hash table without allocations for each place.
class PlaceNumbers {
  public:
    /// Forgets all places. `most`: of places until the next call. `first`: the next number.
    void begin(std::size_t most, std::size_t first) {
        places_.clear();
        first_ = first;
        slots_.assign(std::bit_ceil(most + 2), 0); // at least one stays free
        shift_ = 64 - std::countr_zero(slots_.size());
    }

    std::uint32_t of(const glm::vec3& place) {
        for (std::size_t at = slotOf(place);; at = (at + 1) & (slots_.size() - 1)) {
            std::uint32_t& slot = slots_[at];
            if (slot == 0) {
                places_.push_back(place);
                slot = static_cast<std::uint32_t>(places_.size());
            }
            if (std::memcmp(&places_[slot - 1], &place, sizeof(place)) == 0)
                return static_cast<std::uint32_t>(first_) + slot - 1;
        }
    }

    /// The number after the last one.
    std::size_t next() const { return first_ + places_.size(); }

  private:
    std::size_t slotOf(const glm::vec3& place) const {
        std::array<std::uint32_t, 3> bits;
        std::memcpy(bits.data(), &place, sizeof(place));
        std::uint64_t hash = (std::uint64_t{bits[0]} << 32 | bits[1]) * 0x9E3779B97F4A7C15u;
        hash = (hash ^ (hash >> 32) ^ bits[2]) * 0xC2B2AE3D27D4EB4Fu;
        return static_cast<std::size_t>(hash >> shift_);
    }

    std::vector<std::uint32_t> slots_; ///< 1 + index in places_; 0: free
    std::vector<glm::vec3> places_;
    std::size_t first_ = 0;
    int shift_ = 63;
};

template <class Record>
void number(const std::vector<Record>& records, const RecordRange& range, PlaceNumbers& numbers,
            std::vector<EndNumbers>& ends) {
    for (std::uint32_t i = range.first; i < range.end(); ++i) {
        const std::uint32_t a = numbers.of(records[i].a);
        ends[i] = {a, numbers.of(records[i].b)};
    }
}

} // namespace

EdgeVertices::EdgeVertices(const PlanePairShadow& shadow) {
    if (shadow.vertices) {
        pairs = shadow.vertices->pairs;
        singles = shadow.vertices->singles;
        count = shadow.vertices->inBatch.size();
        return;
    }
    pairs.resize(shadow.pairs.size());
    singles.resize(shadow.singles.size());
    PlaceNumbers numbers;
    for (const ShadowCluster& cluster : shadow.clusters) {
        numbers.begin(2 * (std::size_t{cluster.pairs.count} + cluster.singles.count), count);
        number(shadow.pairs, cluster.pairs, numbers, pairs);
        number(shadow.singles, cluster.singles, numbers, singles);
        count = numbers.next();
    }
}

} // namespace edgeshade
