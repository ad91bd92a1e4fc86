#include "src/viewer/stage_watch.hpp"

#include <algorithm>
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
    milliseconds_[static_cast<std::size_t>(stage_)] += time.count();
}

StageMs StageWatch::stages() const {
    const auto of = [&](FrameStage stage) {
        return milliseconds_[static_cast<std::size_t>(stage)];
    };
    const double silhouette = of(FrameStage::silhouette);
    return {of(FrameStage::ambient), of(FrameStage::map), silhouette,
            std::max(0.0, of(FrameStage::volumes) - silhouette), of(FrameStage::lit)};
}

} // namespace edgeshade::viewer
