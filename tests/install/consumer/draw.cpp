// draw OUT.ppm: draws the picture in its own context, without a window.
#include "picture.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <exception>
#include <iostream>

namespace {

EGLDisplay openDisplay() {
    const auto byPlatform = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display =
        byPlatform ? byPlatform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                   : eglGetDisplay(EGL_DEFAULT_DISPLAY);
    return eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

bool makeContext() {
    const EGLDisplay display = openDisplay();
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_ES2_BIT,
                             EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_DEPTH_SIZE,
                             24,
                             EGL_RED_SIZE,
                             8,
                             EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, pictureWidth, EGL_HEIGHT, pictureHeight, EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglBindAPI(EGL_OPENGL_ES_API);
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return false;
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    return eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
}

} // namespace

int main(int, char** words) {
    if (!makeContext()) {
        std::cerr << "No ES 2.0 context can be had here.\n";
        return 3;
    }
    try {
        drawPicture(
            [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); });
        writePicture(words[1]);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
