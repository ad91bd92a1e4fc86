// A GL whose drawing calls do nothing and which names itself hardware, so that a bench's figures
// are the processor's share of a frame. processor.py loads it with LD_PRELOAD in front of the
// system's libGLESv2 and libEGL.
#include <dlfcn.h>

#include <cstring>
#include <EGL/egl.h>
#include <GLES2/gl2.h>

namespace {

/// The system's function of this name.
template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// Stands for every drawing call that is an extension: instanced, or several draws in one.
void drawNothing() {}

bool startsWith(const char* text, const char* start) {
    return std::strncmp(text, start, std::strlen(start)) == 0;
}

bool draws(const char* name) {
    return startsWith(name, "glDraw") && !startsWith(name, "glDrawBuffers");
}

} // namespace

extern "C" {

void glDrawArrays(GLenum, GLint, GLsizei) {}
void glDrawElements(GLenum, GLsizei, GLenum, const void*) {}
void glClear(GLbitfield) {}

const GLubyte* glGetString(GLenum name) {
    static const auto real = next<const GLubyte* (*)(GLenum)>("glGetString");
    const char* text = name == GL_RENDERER ? "hardware that draws nothing"
                       : name == GL_VENDOR ? "none"
                                           : nullptr;
    return text ? reinterpret_cast<const GLubyte*>(text) : real(name);
}

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
    static const auto real =
        next<__eglMustCastToProperFunctionPointerType (*)(const char*)>("eglGetProcAddress");
    return draws(name) || startsWith(name, "glMultiDraw") ? drawNothing : real(name);
}

} // extern "C"
