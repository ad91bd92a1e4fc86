#pragma once

#include "src/gl/capabilities.hpp"
#include "src/gl/objects.hpp"
#include "src/gl/reset_status.hpp"

#include <optional>
#include <string>

struct GLFWwindow;

namespace edgeshade::desktop {

struct WindowRequest {
    std::string title;
    int width = 1280;
    int height = 720;
    int samples = 0; ///< 0: no antialiasing
    gl::Limits limits = gl::Limits::device;
};

/// GLFW with one window whose OpenGL ES 2 context is current, with 8-bit alpha and stencil.
class Window {
  public:
    /// Throws Error(unavailable) that names what is missing, for example a display.
    explicit Window(const WindowRequest& request);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    const gl::Capabilities& capabilities() const { return capabilities_; }

    /// Throws Error(unavailable) if the context was lost. Drawing after that has no visible effect.
    void requireContext() const;

  private:
    GLFWwindow* window_ = nullptr;
    gl::Capabilities capabilities_;
    std::optional<gl::ResetStatus> reset_; ///< empty if the context can't report a loss
};

} // namespace edgeshade::desktop
