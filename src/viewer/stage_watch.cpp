#include "src/viewer/stage_watch.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::viewer {

void waitForPicture() {
    // A framebuffer object with samples can't be read back. None is used in browsers, the only
    // place where glFinish() doesn't wait.
    GLint framebuffer = 0, sampled = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_SAMPLE_BUFFERS, &sampled);
    if (framebuffer != 0 && sampled != 0) return glFinish();
    GLint format = GL_RGBA, type = GL_UNSIGNED_BYTE;
    glGetIntegerv(GL_IMPLEMENTATION_COLOR_READ_FORMAT, &format);
    glGetIntegerv(GL_IMPLEMENTATION_COLOR_READ_TYPE, &type);
    float pixel[4]; // large enough for every format
    glReadPixels(0, 0, 1, 1, static_cast<GLenum>(format), static_cast<GLenum>(type), pixel);
}

void StageWatch::enter(FrameStage stage) {
    waitForPicture();
    stage_ = stage;
    start_ = std::chrono::steady_clock::now();
}

void StageWatch::leave() {
    waitForPicture();
    const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now() - start_;
    spans_.push_back({static_cast<int>(stage_), time.count(), false});
}

} // namespace edgeshade::viewer
