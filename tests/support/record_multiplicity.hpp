#pragma once

// Results of sides.vert and caps.vert for one record. `Method` is one of shader_arithmetic.hpp's.

#include "preprocess/volumes/published/caps_data.hpp"
#include "preprocess/volumes/published/sides_data.hpp"
#include "tests/support/shader_arithmetic.hpp"

#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace edgeshade::test {

/// sides.vert's edgeMultiplicity(): A, B, then opposite vertices.
template <class Method>
float recordMultiplicity(std::span<const glm::vec4> record, const glm::vec4& light) {
    Method method;
    float multiplicity = 0.0f;
    for (const glm::vec4& opposite : record.subspan(2))
        multiplicity += method.oppositeMultiplicity(glm::vec3(record[0]), glm::vec3(record[1]),
                                                    opposite, light);
    return multiplicity;
}

/// caps.vert's `facing`: A, B, C.
template <class Method>
float capSign(std::span<const glm::vec4> record, const glm::vec4& light) {
    return Method{}.triangleSign(glm::vec3(record[0]), glm::vec3(record[1]), glm::vec3(record[2]),
                                 light);
}

inline std::span<const glm::vec4> sidesRecord(const SidesData& sides, std::size_t record) {
    const std::size_t size = sides.vectorsPerRecord();
    return std::span(sides.records).subspan(record * size, size);
}

inline std::span<const glm::vec4> capsRecord(const CapsData& caps, std::size_t record) {
    return std::span(caps.records)
        .subspan(record * CapsData::vectorsPerRecord, CapsData::vectorsPerRecord);
}

using Point = std::array<float, 3>;

/// Edges with non-zero multiplicity, the smaller vertex first.
using Silhouette = std::map<std::pair<Point, Point>, int>;

inline Point pointOf(const glm::vec4& p) {
    return {p.x, p.y, p.z};
}

/// The silhouette from the records; an edge's multiplicity is the sum over its records.
template <class Method>
Silhouette silhouetteOf(const SidesData& sides, const glm::vec4& light) {
    Silhouette silhouette;
    for (std::size_t r = 0; r < sides.recordCount(); ++r) {
        const auto record = sidesRecord(sides, r);
        silhouette[{pointOf(record[0]), pointOf(record[1])}] +=
            static_cast<int>(std::lround(recordMultiplicity<Method>(record, light)));
    }
    std::erase_if(silhouette, [](const auto& entry) { return entry.second == 0; });
    return silhouette;
}

} // namespace edgeshade::test
