#pragma once

#include "src/gl/instancing.hpp"
#include "src/rivals/published/shadow_buffers.hpp"

namespace edgeshade {

/// How records of triangles reach the vertex shader.
struct CapVertices {
    const gl::Instancing* instancing; ///< null: a copy of each for every vertex
    const gl::Buffer& corners;        ///< else: vec2s, x the number of each of its vertices
    int perRecord;                    ///< vertices
    int first = 0;                    ///< of those that are drawn where records are instanced
    int count = perRecord;            ///< likewise
};

/// Draws some of a batch's triangles by the program that is in use. `alphaTested`: it tests alpha.
void drawCapRecords(const ShadowBuffers& shadow, const RecordRange& caps,
                    const CapVertices& vertices, bool alphaTested);

} // namespace edgeshade
