#include "src/render/stencil_count.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr GLuint allBits = 0xFF, lowestBit = 0x01, highestBit = 0x80;

void clearBits(GLuint bits, int value) {
    glStencilMask(bits);
    glClearStencil(value);
    glClear(GL_STENCIL_BUFFER_BIT);
}

} // namespace

void clearStencil(int count) {
    clearBits(allBits, count & 0xFF); // counts wrap
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

int halvedStart(int start) {
    return (start & 0xFF) >> 1;
}

void doubleCounts(int start, WholePicture& picture) {
    glDisable(GL_DEPTH_TEST);
    // Where the lower bit is 1 the two become 10, else 00.
    glStencilOp(GL_ZERO, GL_KEEP, GL_REPLACE);
    for (GLuint higher = highestBit; higher != lowestBit; higher >>= 1) {
        const GLuint lower = higher >> 1;
        glStencilFunc(GL_NOTEQUAL, static_cast<GLint>(higher), lower);
        glStencilMask(higher | lower);
        picture.draw();
    }
    if ((start & 1) != 0) clearBits(lowestBit, 1);
    glStencilMask(allBits);
    glStencilFunc(GL_ALWAYS, 0, allBits);
    glEnable(GL_DEPTH_TEST);
}

} // namespace edgeshade
