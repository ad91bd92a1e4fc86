#include "src/gl/headless_context.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/depth_precision.hpp"
#include "src/gl/entry_points.hpp"
#include "src/gl/objects.hpp"

#include <algorithm>
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES2/gl2.h>
#include <string>

namespace edgeshade::gl {
namespace {

[[noreturn]] void unavailable(const std::string& sentence) {
    throw Error(ExitStatus::unavailable, sentence);
}

bool lists(const char* extensions, const std::string& name) {
    return extensions && listsExtension(extensions, name);
}

template <class Function>
Function entryPoint(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

void* lookUp(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

/// Displays to try, best first.
std::vector<EGLDisplay> candidateDisplays() {
    std::vector<EGLDisplay> displays;
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const auto platformDisplay =
        entryPoint<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    const auto queryDevices = entryPoint<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto queryDevice = entryPoint<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    if (platformDisplay && queryDevices && queryDevice &&
        lists(client, "EGL_EXT_platform_device")) {
        EGLDeviceEXT devices[16];
        EGLint count = 0;
        if (queryDevices(16, devices, &count))
            for (EGLint i = 0; i < count; ++i)
                if (!lists(queryDevice(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
                    displays.push_back(
                        platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
    if (platformDisplay && lists(client, "EGL_MESA_platform_surfaceless"))
        displays.push_back(
            platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

EGLConfig chooseConfig(EGLDisplay display, int depthBits) {
    const EGLint attributes[] = {EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_ES2_BIT,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 depthBits,
                                 EGL_STENCIL_SIZE,
                                 8,
                                 EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, attributes, &config, 1, &count) || count == 0) return nullptr;
    return config;
}

/// Creates a context that reports its loss, if possible.
EGLContext createContext(EGLDisplay display, EGLConfig config) {
    const EGLint robust[] = {EGL_CONTEXT_CLIENT_VERSION, 2,
                             EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT,
                             EGL_LOSE_CONTEXT_ON_RESET_EXT, EGL_NONE};
    const EGLint plain[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (lists(eglQueryString(display, EGL_EXTENSIONS), "EGL_EXT_create_context_robustness"))
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, robust);
    return context ? context : eglCreateContext(display, config, EGL_NO_CONTEXT, plain);
}

int configValue(EGLDisplay display, EGLConfig config, EGLint name) {
    EGLint value = 0;
    eglGetConfigAttrib(display, config, name, &value);
    return value;
}

} // namespace

HeadlessContext::HeadlessContext(const Request& request)
    : width_(request.width), height_(request.height) {
    EGLConfig config = nullptr;
    bool anyDisplay = false;
    for (EGLDisplay candidate : candidateDisplays()) {
        if (candidate == EGL_NO_DISPLAY) continue;
        display_ = openDisplay(candidate);
        if (!display_) continue;
        anyDisplay = true;
        config = chooseConfig(candidate, request.depthBits);
        if (!config) config = chooseConfig(candidate, 16);
        if (config) break;
    }
    if (!anyDisplay) unavailable("No EGL display can be opened here, so nothing can be drawn.");
    if (!config)
        unavailable("EGL offers no pbuffer with 8-bit colour, depth and an 8-bit stencil here.");
    const int widest = configValue(display_.get(), config, EGL_MAX_PBUFFER_WIDTH);
    const int highest = configValue(display_.get(), config, EGL_MAX_PBUFFER_HEIGHT);
    if (width_ > widest || height_ > highest)
        unavailable("A picture of " + std::to_string(width_) + "x" + std::to_string(height_) +
                    " is too large here; the largest is " + std::to_string(widest) + "x" +
                    std::to_string(highest) + ".");

    try {
        makeCurrent(config);
        const Capabilities device = queryCapabilities(lookUp);
        capabilities_ = limited(device, request.limits);
        if (capabilities_.depthBits < 16 || capabilities_.stencilBits < 8)
            unavailable("This GL has " + std::to_string(capabilities_.depthBits) +
                        " bits of depth and " + std::to_string(capabilities_.stencilBits) +
                        " of stencil; shadow volumes need 16 and 8.");
        coarsenDepth(device.depthBits, capabilities_.depthBits);
        reset_ = ResetStatus::find(device.version, device.extensions, lookUp);
        if (request.samples == 0) return;
        multisampled_.emplace(width_, height_, request.samples, capabilities_.version,
                              capabilities_.extensions, lookUp);
        capabilities_.samples = multisampled_->samples();
    } catch (...) {
        release();
        throw;
    }
}

void HeadlessContext::makeCurrent(void* config) {
    EGLDisplay display = display_.get();
    eglBindAPI(EGL_OPENGL_ES_API);
    context_ = createContext(display, config);
    const EGLint size[] = {EGL_WIDTH, width_, EGL_HEIGHT, height_, EGL_NONE};
    if (context_) surface_ = eglCreatePbufferSurface(display, config, size);
    if (surface_ && eglMakeCurrent(display, surface_, surface_, context_)) return;
    const bool memory = eglGetError() == EGL_BAD_ALLOC;
    unavailable(std::string("EGL can't make an OpenGL ES 2 context with a picture of ") +
                std::to_string(width_) + "x" + std::to_string(height_) + " here" +
                (memory ? ": it is out of memory." : "."));
}

HeadlessContext::~HeadlessContext() {
    release();
}

void HeadlessContext::release() {
    EGLDisplay display = display_.get();
    const CurrentContext current;
    const bool isCurrent = current.context() == context_;
    if (multisampled_ && !isCurrent) eglMakeCurrent(display, surface_, surface_, context_);
    multisampled_.reset();
    (isCurrent ? before_ : current).restore(display);
    if (surface_) eglDestroySurface(display, surface_);
    if (context_) eglDestroyContext(display, context_);
}

std::vector<std::uint8_t> HeadlessContext::readPixels(int width, int height) const {
    const std::size_t stride = std::size_t{4} * static_cast<std::size_t>(width);
    std::vector<std::uint8_t> pixels(stride * static_cast<std::size_t>(height));
    if (multisampled_) multisampled_->resolve();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    if (multisampled_) multisampled_->bind();
    requireNoError("reading the picture");
    if (reset_ && reset_->wasReset()) requireNoError(contextLost, "reading the picture");
    for (std::size_t top = 0, bottom = static_cast<std::size_t>(height) - 1; top < bottom;
         ++top, --bottom)
        std::swap_ranges(pixels.begin() + top * stride, pixels.begin() + (top + 1) * stride,
                         pixels.begin() + bottom * stride);
    return pixels;
}

} // namespace edgeshade::gl
