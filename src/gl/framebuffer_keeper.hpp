#pragma once

namespace edgeshade::gl {

/// For drawing elsewhere in between: the framebuffer that was bound is bound again, whatever
/// happens; so are the scissor, which cuts that framebuffer's picture and is off until then, and
/// the depth range, which is whole until then.
class FramebufferKeeper {
  public:
    FramebufferKeeper();
    ~FramebufferKeeper();
    FramebufferKeeper(const FramebufferKeeper&) = delete;
    FramebufferKeeper& operator=(const FramebufferKeeper&) = delete;

  private:
    int name_ = 0;
    bool scissor_;
    int scissorBox_[4] = {}; ///< where it was on
    float depthRange_[2] = {};
    float depthClear_ = 1.0f;
};

} // namespace edgeshade::gl
