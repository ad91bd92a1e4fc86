#pragma once

#include "preprocess/volumes/shadow_data.hpp"
#include "src/gl/objects.hpp"
#include "src/shadow/plan/published/opposite_vertex_draws.hpp"

#include <vector>

namespace edgeshade {

/// How records reach the vertex shader (thesis, 6.2.6).
enum class SidesLayout {
    instanced, ///< one record per instance, all its sides in one draw
    multiDraw, ///< one record per instance, one draw per side, with the side's index as a uniform
    notInstanced, ///< a copy of the record for every vertex; needs no extension
};

/// Records [first, first + count) in one buffer.
struct RecordChunk {
    gl::Buffer buffer;
    std::size_t firstRecord = 0;
    std::size_t recordCount = 0;
};

/// One batch's shadow data on the GPU.
struct ShadowBuffers {
    int maxMultiplicity = 1;
    std::vector<RecordChunk> sides; ///< one if instanced; otherwise as many as keep buffers small
    std::vector<RecordChunk> caps;  ///< divided like the sides
    std::vector<MaterialCasters> groups;
    gl::Buffer alphaCorners; ///< three vec4s per cap, copied six times if not instanced; or empty

    std::size_t sideBytes() const;
    std::size_t capBytes() const; ///< including alphaCorners
    std::size_t bytes() const { return sideBytes() + capBytes(); }

    /// The records that can be drawn.
    OppositeVertexRecords records() const;
};

/// Uploads sides and caps; `alphaCorners` (see scene/load.hpp) may be empty.
ShadowBuffers uploadShadow(const BatchShadow& shadow, const std::vector<glm::vec4>& alphaCorners,
                           SidesLayout layout);

/// Uploads triangles that each have their own volume, without sides.
ShadowBuffers uploadTriangles(const CasterMesh& mesh, const std::vector<glm::vec4>& alphaCorners,
                              SidesLayout layout);

} // namespace edgeshade
