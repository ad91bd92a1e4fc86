#include "src/gl/egl_display.hpp"

#include <cstddef>
#include <EGL/egl.h>
#include <map>
#include <mutex>

namespace edgeshade::gl {
namespace {

/// How a display is used here.
struct Use {
    std::size_t users = 0;
    bool closes = false; ///< with the last user; otherwise the application had opened it
};

struct Displays {
    std::mutex mutex;
    std::map<EGLDisplay, Use> used;
};

Displays& displays() {
    // Never destroyed: contexts may live until the process ends.
    static Displays& all = *new Displays;
    return all;
}

/// Opens the display if it isn't open, and counts one more user. Whether it is open.
bool enter(EGLDisplay display) {
    Displays& all = displays();
    const std::lock_guard lock(all.mutex);
    Use& use = all.used[display];
    if (use.users == 0) {
        use.closes = !eglQueryString(display, EGL_VERSION);
        if (use.closes && !eglInitialize(display, nullptr, nullptr)) return false;
    }
    ++use.users;
    return true;
}

void leave(EGLDisplay display) {
    Displays& all = displays();
    const std::lock_guard lock(all.mutex);
    Use& use = all.used[display];
    if (--use.users == 0 && use.closes) eglTerminate(display);
}

} // namespace

std::shared_ptr<void> openDisplay(void* display) {
    if (!enter(display)) return nullptr;
    return {display, leave};
}

CurrentContext::CurrentContext()
    : display_(eglGetCurrentDisplay()), draw_(eglGetCurrentSurface(EGL_DRAW)),
      read_(eglGetCurrentSurface(EGL_READ)), context_(eglGetCurrentContext()) {}

void CurrentContext::restore(void* display) const {
    if (context_ && eglMakeCurrent(display_, draw_, read_, context_)) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace edgeshade::gl
