#include "src/render/stencil_count.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {
namespace {

constexpr GLuint allBits = 0xFF, lowestBit = 0x01;

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

int clearedForTwo(int start) {
    return start ^ 1; // the lowest bit as the first direction needs it
}

void countByTwo(int start, const std::function<void(bool up)>& draw) {
    const bool odd = (start & 1) != 0;
    glEnable(GL_CULL_FACE);
    for (const bool up : {!odd, odd}) {
        if (up == odd) clearBits(lowestBit, odd ? 1 : 0);
        glStencilMask(allBits & ~lowestBit);
        draw(up);
    }
    glStencilMask(allBits);
    glDisable(GL_CULL_FACE);
}

void countStepOfTwo(bool up, bool zFail, bool mirrored) {
    const bool front = up != zFail;
    glCullFace(front != mirrored ? GL_BACK : GL_FRONT);
    const GLenum step = up ? GL_INCR_WRAP : GL_DECR_WRAP;
    glStencilOp(GL_KEEP, zFail ? step : GL_KEEP, zFail ? GL_KEEP : step);
}

} // namespace edgeshade
