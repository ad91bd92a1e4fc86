#pragma once

#include "preprocess/volumes/plane_pair_records.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgeshade {

/// The numbers of an edge's ends.
using EndNumbers = std::array<std::uint32_t, 2>;

/// Numbers the ends of records' edges. Ends with the same number are at the same place, to the bit.
/// A place that is in many records, or in records that are far apart, may have several numbers.
struct EdgeVertices {
    std::vector<EndNumbers> pairs, singles; ///< a and b of each record
    std::vector<glm::vec3> places;          ///< by number

    /// Linear in the records.
    explicit EdgeVertices(const PlanePairShadow& shadow);
};

} // namespace edgeshade
