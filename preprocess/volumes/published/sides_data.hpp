#pragma once

#include "preprocess/mesh/edges.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The opposite-vertex sides-data, instanced form (thesis, 6.2.6): per edge one record of 2 +
/// maxMultiplicity vec4s. A and B come first with w = 0, then the opposite vertices with w =
/// ORDER_* of shaders_es2/record_layout.glsl. 16 * (2 + maxMultiplicity) bytes a record.
struct SidesData {
    int maxMultiplicity = 1; ///< 1..LARGEST_RECORD_MULTIPLICITY
    std::vector<glm::vec4> records;

    std::size_t vectorsPerRecord() const { return static_cast<std::size_t>(2 + maxMultiplicity); }
    std::size_t recordCount() const { return records.size() / vectorsPerRecord(); }
};

/// The number of opposite vertices that records need for such edges, at least 1.
int recordMultiplicityFor(std::uint32_t largestOppositeCount);

/// The number of records for the edges. An edge with more than `maxMultiplicity` opposite vertices
/// is split, and its multiplicity is the sum over its records.
std::size_t recordCountFor(const EdgeList& edges, int maxMultiplicity);

/// Makes the records, in the order of the edges.
SidesData buildSides(std::span<const glm::vec3> positions, const EdgeList& edges,
                     int maxMultiplicity);

/// The copied form of records [first, first + count): maxMultiplicity * 6 vertices per record. Each
/// has a copy of the record with A.w = v in 0..5 and B.w = s in 0..maxMultiplicity-1.
/// maxMultiplicity * 6 * 16 * (2 + maxMultiplicity) bytes a record.
std::vector<glm::vec4> expandSides(const SidesData& sides, std::size_t first, std::size_t count);

} // namespace edgeshade
