#include "src/viewer/stage_watch.hpp"

#include <cstdint>
#include <GLES2/gl2.h>

namespace edgeshade::viewer {

void waitForPicture() {
    std::uint8_t pixel[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
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
