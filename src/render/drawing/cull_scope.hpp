#pragma once

#include <GLES2/gl2.h>

namespace edgeshade {

/// Culls one side of all triangles for its lifetime.
class CullScope {
  public:
    explicit CullScope(GLenum side) : CullScope(true, side) {}
    /// Backs, where they are `culled`. `mirrored`: the batch turns its triangles over.
    CullScope(bool culled, bool mirrored)
        : CullScope(culled, GLenum(mirrored ? GL_FRONT : GL_BACK)) {}
    ~CullScope() {
        if (culls_) glDisable(GL_CULL_FACE);
    }
    CullScope(const CullScope&) = delete;
    CullScope& operator=(const CullScope&) = delete;

  private:
    CullScope(bool culls, GLenum side) : culls_(culls) {
        if (!culls) return;
        glEnable(GL_CULL_FACE);
        glCullFace(side);
    }

    bool culls_;
};

} // namespace edgeshade
