#pragma once

#include "src/gl/instancing.hpp"
#include "src/rivals/published/shadow_buffers.hpp"

namespace edgeshade {

/// How records of triangles reach the vertex shader.
struct CapVertices {
    const gl::Instancing* instancing; ///< null: each record is copied for every vertex
    const gl::Buffer& corners;        ///< instanced: vec2s whose x is the vertex's number in its
                                      ///< record
    int perRecord;                    ///< vertices
    int first = 0;                    ///< instanced: first vertex drawn
    int count = perRecord;            ///< instanced: number of vertices drawn
};

/// Draws some of a batch's triangles with the program in use. `alphaTested`: that program tests
/// alpha.
void drawCapRecords(const ShadowBuffers& shadow, const RecordRange& caps,
                    const CapVertices& vertices, bool alphaTested);

} // namespace edgeshade
