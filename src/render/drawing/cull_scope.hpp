#pragma once

#include <GLES2/gl2.h>

namespace edgeshade {

/// Culls one side of all triangles for its lifetime.
class CullScope {
  public:
    explicit CullScope(GLenum side) {
        glEnable(GL_CULL_FACE);
        glCullFace(side);
    }
    ~CullScope() { glDisable(GL_CULL_FACE); }
    CullScope(const CullScope&) = delete;
    CullScope& operator=(const CullScope&) = delete;
};

} // namespace edgeshade
