#pragma once

namespace edgeshade::gl {

/// For drawing elsewhere in between: the framebuffer that was bound is bound again, whatever
/// happens; so is the scissor, which cuts that framebuffer's picture and is off until then.
class FramebufferKeeper {
  public:
    FramebufferKeeper();
    ~FramebufferKeeper();
    FramebufferKeeper(const FramebufferKeeper&) = delete;
    FramebufferKeeper& operator=(const FramebufferKeeper&) = delete;

  private:
    int name_ = 0;
    bool scissor_;
};

} // namespace edgeshade::gl
