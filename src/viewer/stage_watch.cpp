#include "src/viewer/stage_watch.hpp"

#include "src/gl/objects.hpp"

#include <GLES2/gl2.h>

namespace edgeshade::viewer {

void waitForPicture() {
    // A framebuffer object with samples can't be read back. None is used in browsers, the only
    // place where glFinish() doesn't wait.
    if (gl::boundFramebuffer() != 0 && gl::integerOf(GL_SAMPLE_BUFFERS) != 0) return glFinish();
    const auto format = static_cast<GLenum>(gl::integerOf(GL_IMPLEMENTATION_COLOR_READ_FORMAT));
    const auto type = static_cast<GLenum>(gl::integerOf(GL_IMPLEMENTATION_COLOR_READ_TYPE));
    float pixel[4]; // large enough for every format
    glReadPixels(0, 0, 1, 1, format, type, pixel);
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
