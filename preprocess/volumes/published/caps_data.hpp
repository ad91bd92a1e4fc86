#pragma once

#include "preprocess/mesh/weld.hpp"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The opposite-vertex caps-data, instanced form (thesis, 6.2.6): a record a triangle of three
/// vec4s A < B < C with w = 0; 48 bytes a record.
struct CapsData {
    static constexpr std::size_t vectorsPerRecord = 3;
    std::vector<glm::vec4> records;

    std::size_t recordCount() const { return records.size() / vectorsPerRecord; }
};

/// A triangle's vertices in ascending order, and so of their positions.
Triangle sortedTriangle(Triangle triangle);

/// Emits the records, in the order of the triangles.
CapsData buildCaps(const WeldedMesh& mesh);

/// The not instanced form of records [first, first + count): six vertices a record, each with a
/// copy of it and A.w = v in 0..5. 288 bytes a record.
std::vector<glm::vec4> expandCaps(const CapsData& caps, std::size_t first, std::size_t count);

} // namespace edgeshade
