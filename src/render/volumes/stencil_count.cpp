#include "src/render/volumes/stencil_count.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr GLuint allBits = 0xFF, lowestBit = 0x01, highestBit = 0x80;

} // namespace

void setStencilClear(const StencilStart& start) {
    glStencilMask(allBits);
    glClearStencil(start.cleared());
}

void clearStencil(const StencilStart& start) {
    setStencilClear(start);
    glClear(GL_STENCIL_BUFFER_BIT);
}

void countByOne(bool zFail, bool mirrored) {
    const GLenum front = mirrored ? GL_BACK : GL_FRONT;
    const GLenum back = mirrored ? GL_FRONT : GL_BACK;
    if (zFail) {
        glStencilOpSeparate(front, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
        glStencilOpSeparate(back, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    } else {
        glStencilOpSeparate(front, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
        glStencilOpSeparate(back, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
    }
}

void doubleCounts(const StencilStart& start, const WholePicture& picture) {
    glDisable(GL_DEPTH_TEST);
    // If the lower bit is 1, the two bits become 10, otherwise 00.
    glStencilOp(GL_ZERO, GL_KEEP, GL_REPLACE);
    for (GLuint higher = highestBit; higher != lowestBit; higher >>= 1) {
        const GLuint lower = higher >> 1;
        glStencilFunc(GL_NOTEQUAL, static_cast<GLint>(higher), lower);
        glStencilMask(higher | lower);
        picture.draw();
    }
    if (start.isOddWhenDoubled()) {
        glStencilMask(lowestBit);
        glClearStencil(1);
        glClear(GL_STENCIL_BUFFER_BIT);
    }
    glStencilMask(allBits);
    glStencilFunc(GL_ALWAYS, 0, allBits);
    glEnable(GL_DEPTH_TEST);
}

} // namespace edgeshade
