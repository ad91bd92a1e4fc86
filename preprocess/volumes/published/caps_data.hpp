#pragma once

#include "preprocess/mesh/weld.hpp"
#include "shaders_es2/record_layout.glsl"

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

/// The not instanced form of records [first, first + count): `vertices` a record, six for a pair of
/// caps, each with a copy of it and A.w = v in 0..vertices - 1. 48 bytes a vertex.
std::vector<glm::vec4> expandCaps(const CapsData& caps, std::size_t first, std::size_t count,
                                  int vertices = VERTICES_PER_CAP_PAIR);

} // namespace edgeshade
