#pragma once

#include "preprocess/volumes/shadow_data.hpp"
#include "src/gl/objects.hpp"
#include "src/rivals/published/opposite_vertex_draws.hpp"
#include "src/scene/record_source.hpp"

#include <vector>

namespace edgeshade {

/// Records [first, first + count) in one buffer.
struct RecordChunk {
    gl::Buffer buffer;
    std::size_t firstRecord = 0;
    std::size_t recordCount = 0;
};

/// One batch's shadow data on the GPU.
struct ShadowBuffers : RecordBuffers {
    int maxMultiplicity = 1;
    std::vector<RecordChunk> sides; ///< one if instanced; otherwise as many as keep buffers small
    std::vector<RecordChunk> caps;  ///< divided like the sides
    std::vector<MaterialCasters> groups;
    gl::Buffer alphaCorners; ///< three vec4s per cap, copied six times if not instanced; or empty

    std::size_t sideBytes() const override;
    std::size_t capBytes() const override; ///< including alphaCorners

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
