#pragma once

#include "src/gl/capabilities.hpp"

#include <string>

struct GLFWwindow;

namespace edgeshade::desktop {

struct WindowRequest {
    std::string title;
    int width = 1280;
    int height = 720;
    int samples = 0; ///< 0: no antialiasing
};

/// GLFW with one window whose OpenGL ES 2 context is current, with 8-bit alpha and stencil.
class Window {
  public:
    /// Throws Error(unavailable) that says what is missing, a display for instance.
    explicit Window(const WindowRequest& request);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    const gl::Capabilities& capabilities() const { return capabilities_; }

  private:
    GLFWwindow* window_ = nullptr;
    gl::Capabilities capabilities_;
};

} // namespace edgeshade::desktop
