#pragma once

namespace edgeshade::gl {

/// Saves the bound framebuffer, the scissor and the depth range while the program draws elsewhere,
/// and restores them on destruction. Until then the scissor, which belongs to that framebuffer's
/// picture, is off, and the depth range is full.
class FramebufferKeeper {
  public:
    FramebufferKeeper();
    ~FramebufferKeeper();
    FramebufferKeeper(const FramebufferKeeper&) = delete;
    FramebufferKeeper& operator=(const FramebufferKeeper&) = delete;

  private:
    int name_ = 0;
    bool scissor_;
    int scissorBox_[4] = {}; ///< saved if the scissor was on
    float depthRange_[2] = {};
    float depthClear_ = 1.0f;
};

} // namespace edgeshade::gl
