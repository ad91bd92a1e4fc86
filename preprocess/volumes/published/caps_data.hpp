#pragma once

#include "preprocess/mesh/weld.hpp"
#include "shaders_es2/record_layout.glsl"

#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// The opposite-vertex caps-data, instanced form (thesis, 6.2.6): per triangle one record of three
/// vec4s A < B < C with w = 0; 48 bytes a record.
struct CapsData {
    static constexpr std::size_t vectorsPerRecord = 3;
    std::vector<glm::vec4> records;

    std::size_t recordCount() const { return records.size() / vectorsPerRecord; }
};

/// A triangle's vertices in ascending order, and so in ascending order of their positions.
Triangle sortedTriangle(Triangle triangle);

/// Makes the records, in the order of the triangles.
CapsData buildCaps(const WeldedMesh& mesh);

/// The copied form of records [first, first + count): `vertices` vertices per record, six for a
/// pair of caps. Each has a copy of the record with A.w = v in 0..vertices - 1. 48 bytes a vertex.
std::vector<glm::vec4> expandCaps(const CapsData& caps, std::size_t first, std::size_t count,
                                  int vertices = VERTICES_PER_CAP_PAIR);

} // namespace edgeshade
