#include "src/desktop/window.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/depth_precision.hpp"

#define GLFW_INCLUDE_NONE
#include <GLES2/gl2.h>
#include <GLFW/glfw3.h>

namespace edgeshade::desktop {
namespace {

/// GLFW's own message about the last error.
std::string lastError() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? clauseOf(text) : "GLFW gives no reason";
}

[[noreturn]] void unavailable(const std::string& sentence) {
    throw Error(ExitStatus::unavailable, sentence);
}

void* lookUp(const char* name) {
    return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

void askForEs2(int samples) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_RED_BITS, 8);
    glfwWindowHint(GLFW_GREEN_BITS, 8);
    glfwWindowHint(GLFW_BLUE_BITS, 8);
    glfwWindowHint(GLFW_ALPHA_BITS, 8);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_STENCIL_BITS, 8);
    glfwWindowHint(GLFW_SAMPLES, samples);
}

} // namespace

Window::Window(const WindowRequest& request) {
    if (!glfwInit())
        unavailable("No window can be opened here (" + lastError() +
                    "); 'edgeshade render' draws without a display.");
    askForEs2(request.samples);
    window_ =
        glfwCreateWindow(request.width, request.height, request.title.c_str(), nullptr, nullptr);
    if (!window_) {
        const std::string reason = lastError();
        glfwTerminate();
        unavailable("No window with OpenGL ES 2 can be opened here (" + reason + ").");
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    const gl::Capabilities device = gl::queryCapabilities(lookUp);
    capabilities_ = gl::limited(device, request.limits);
    gl::coarsenDepth(device.depthBits, capabilities_.depthBits);
    const int alphaBits = gl::integerOf(GL_ALPHA_BITS);
    reset_ = gl::ResetStatus::find(device.version, device.extensions, lookUp);
    if (capabilities_.depthBits >= 16 && capabilities_.stencilBits >= 8 && alphaBits >= 8) return;
    glfwDestroyWindow(window_);
    glfwTerminate();
    unavailable(
        "This display's windows lack depth, 8-bit stencil or alpha, which shadow volumes need.");
}

void Window::requireContext() const {
    const GLenum error = glGetError();
    if (error == gl::contextLost || (reset_ && reset_->wasReset()))
        gl::requireNoError(gl::contextLost, "drawing into the window");
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

} // namespace edgeshade::desktop
