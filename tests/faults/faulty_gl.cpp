// A GL that fails on demand. Preloaded (LD_PRELOAD), its functions replace those of EGL and GLES,
// and pass on whatever isn't to fail. It also counts objects that are created and never deleted.
#include "faulty_gl.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <EGL/egl.h>
#include <GLES2/gl2.h>
#include <map>
#include <string>
#include <utility>

namespace {

namespace fault = edgeshade::test::fault;

constexpr GLenum contextLost = 0x0507;

/// The fault and the living objects; one per process, like the GL's own state.
struct State {
    std::string word;
    int turn = 1; ///< of the Nth
    std::map<std::string, int> seen;
    std::map<std::string, long> alive;
    GLenum error = GL_NO_ERROR; ///< recorded by a fault
    GLuint refused = 0;         ///< the shader or program that is refused
    bool lost = false;

    State() {
        const char* text = std::getenv(edgeshade::test::faultVariable);
        word = text ? text : "";
        if (const std::size_t colon = word.find(':'); colon != std::string::npos) {
            turn = std::atoi(word.c_str() + colon + 1);
            word.resize(colon);
        }
    }

    ~State() {
        const char* path = std::getenv(edgeshade::test::leakVariable);
        std::FILE* file = path ? std::fopen(path, "w") : nullptr;
        if (!file) return;
        for (const auto& [name, count] : alive)
            if (count != 0) std::fprintf(file, "%s %ld\n", name.c_str(), count);
        std::fclose(file);
    }

    bool is(const char* name) const { return word == name; }
    /// Whether this call, of the fault's kind, is the one that fails.
    bool strikes(const char* name) { return is(name) && ++seen[word] == turn; }

    void draws() {
        if (strikes(fault::lost) || strikes(fault::lostSilently)) lost = true;
    }
};

State& state() {
    static State the;
    return the;
}

template <class Function>
Function real(Function, const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}
#define REAL(function) real(&function, #function)

/// Whether this allocation fails.
bool refusesMemory() {
    if (!state().strikes(fault::noMemory)) return false;
    state().error = GL_OUT_OF_MEMORY;
    return true;
}

GLenum resetStatus() {
    return state().lost ? 0x8253 /* GUILTY_CONTEXT_RESET */ : GL_NO_ERROR;
}

using Storage = void (*)(GLenum, GLsizei, GLenum, GLsizei, GLsizei);
using InstancedArrays = void (*)(GLenum, GLint, GLsizei, GLsizei);
using InstancedElements = void (*)(GLenum, GLsizei, GLenum, const void*, GLsizei);
Storage realStorage = nullptr;
InstancedArrays realInstancedArrays = nullptr;
InstancedElements realInstancedElements = nullptr;

void storage(GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height) {
    if (!refusesMemory()) realStorage(target, samples, format, width, height);
}
void instancedArrays(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
    state().draws();
    realInstancedArrays(mode, first, count, instances);
}
void instancedElements(GLenum mode, GLsizei count, GLenum type, const void* at, GLsizei instances) {
    state().draws();
    realInstancedElements(mode, count, type, at, instances);
}

/// Stores the real function and returns the replacement.
template <class Function>
auto replaced(Function& kept, Function ours, void (*found)()) {
    kept = reinterpret_cast<Function>(found);
    return reinterpret_cast<void (*)()>(ours);
}

/// A program with a shader that isn't compiled can't be linked.
bool hasRefusedShader(GLuint program) {
    GLuint shaders[2] = {};
    GLsizei count = 0;
    REAL(glGetAttachedShaders)(program, 2, &count, shaders);
    return std::count(shaders, shaders + count, state().refused) > 0;
}

} // namespace

extern "C" {

// EGL.

EGLBoolean eglChooseConfig(EGLDisplay display, const EGLint* attributes, EGLConfig* configs,
                           EGLint size, EGLint* count) {
    if (state().is(fault::noConfig)) {
        *count = 0;
        return EGL_TRUE;
    }
    return REAL(eglChooseConfig)(display, attributes, configs, size, count);
}

EGLBoolean eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
    long& displays = state().alive["displays"];
    const EGLBoolean done = REAL(eglInitialize)(display, major, minor);
    if (done) ++displays;
    return done;
}

EGLBoolean eglTerminate(EGLDisplay display) {
    --state().alive["displays"];
    return REAL(eglTerminate)(display);
}

EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext share,
                            const EGLint* attributes) {
    if (state().is(fault::noContext)) return EGL_NO_CONTEXT;
    EGLContext context = REAL(eglCreateContext)(display, config, share, attributes);
    if (context) ++state().alive["contexts"];
    return context;
}

EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
    --state().alive["contexts"];
    return REAL(eglDestroyContext)(display, context);
}

EGLSurface eglCreatePbufferSurface(EGLDisplay display, EGLConfig config, const EGLint* attributes) {
    if (state().is(fault::noSurface)) return EGL_NO_SURFACE;
    EGLSurface surface = REAL(eglCreatePbufferSurface)(display, config, attributes);
    if (surface) ++state().alive["surfaces"];
    return surface;
}

EGLBoolean eglDestroySurface(EGLDisplay display, EGLSurface surface) {
    --state().alive["surfaces"];
    return REAL(eglDestroySurface)(display, surface);
}

EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read,
                          EGLContext context) {
    if (state().is(fault::noCurrent) && context) return EGL_FALSE;
    return REAL(eglMakeCurrent)(display, draw, read, context);
}

EGLint eglGetError() {
    if (state().is(fault::noSurface)) return EGL_BAD_ALLOC;
    return REAL(eglGetError)();
}

void (*eglGetProcAddress(const char* name))() {
    const std::string word = name;
    void (*found)() = REAL(eglGetProcAddress)(name);
    if (word.starts_with("glGetGraphicsResetStatus"))
        return reinterpret_cast<void (*)()>(&resetStatus);
    if (!found) return found;
    if (word.starts_with("glRenderbufferStorageMultisample"))
        return replaced<Storage>(realStorage, &storage, found);
    if (word.starts_with("glDrawArraysInstanced"))
        return replaced<InstancedArrays>(realInstancedArrays, &instancedArrays, found);
    if (word.starts_with("glDrawElementsInstanced"))
        return replaced<InstancedElements>(realInstancedElements, &instancedElements, found);
    return found;
}

// Description of the context.

const GLubyte* glGetString(GLenum name) {
    const GLubyte* text = REAL(glGetString)(name);
    if (state().is(fault::noExtensions) && name == GL_VERSION)
        return reinterpret_cast<const GLubyte*>("OpenGL ES 2.0");
    if (state().is(fault::noExtensions) && name == GL_EXTENSIONS)
        return reinterpret_cast<const GLubyte*>("");
    // Makes the silent loss noticeable here too.
    if (state().is(fault::lostSilently) && name == GL_EXTENSIONS) {
        static const std::string more =
            std::string(reinterpret_cast<const char*>(text)) + " GL_EXT_robustness";
        return reinterpret_cast<const GLubyte*>(more.c_str());
    }
    return text;
}

void glGetIntegerv(GLenum name, GLint* values) {
    REAL(glGetIntegerv)(name, values);
    if (name == GL_STENCIL_BITS && state().is(fault::noStencil)) *values = 0;
    if (name == GL_DEPTH_BITS && state().is(fault::noDepth)) *values = 0;
}

GLenum glGetError() {
    if (state().lost && state().is(fault::lost)) return contextLost;
    const GLenum recorded = std::exchange(state().error, GL_NO_ERROR);
    const GLenum found = REAL(glGetError)();
    return recorded != GL_NO_ERROR ? recorded : found;
}

// Allocations.

void glBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (!refusesMemory()) REAL(glBufferData)(target, size, data, usage);
}

void glTexImage2D(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
                  GLint border, GLenum format, GLenum type, const void* data) {
    if (!refusesMemory())
        REAL(glTexImage2D)(target, level, internal, width, height, border, format, type, data);
}

void glRenderbufferStorage(GLenum target, GLenum format, GLsizei width, GLsizei height) {
    if (!refusesMemory()) REAL(glRenderbufferStorage)(target, format, width, height);
}

GLenum glCheckFramebufferStatus(GLenum target) {
    if (state().is(fault::noTarget)) return GL_FRAMEBUFFER_UNSUPPORTED;
    return REAL(glCheckFramebufferStatus)(target);
}

// Shaders.

void glCompileShader(GLuint shader) {
    REAL(glCompileShader)(shader);
    if (state().strikes(fault::noCompile)) state().refused = shader;
}

void glLinkProgram(GLuint program) {
    REAL(glLinkProgram)(program);
    if (state().strikes(fault::noLink)) state().refused = program;
}

void glGetShaderiv(GLuint shader, GLenum name, GLint* value) {
    REAL(glGetShaderiv)(shader, name, value);
    const bool refused = state().is(fault::noCompile) && shader == state().refused;
    if (name == GL_COMPILE_STATUS && refused) *value = GL_FALSE;
}

void glGetProgramiv(GLuint program, GLenum name, GLint* value) {
    REAL(glGetProgramiv)(program, name, value);
    const bool refused = state().is(fault::noLink)
                             ? program == state().refused
                             : state().is(fault::noCompile) && hasRefusedShader(program);
    if (name == GL_LINK_STATUS && refused) *value = GL_FALSE;
}

void glGetShaderInfoLog(GLuint shader, GLsizei size, GLsizei* length, GLchar* log) {
    if (state().is(fault::noCompile))
        std::snprintf(log, static_cast<std::size_t>(size), "0:1: too many words\n");
    else
        REAL(glGetShaderInfoLog)(shader, size, length, log);
}

// Draws.

void glDrawArrays(GLenum mode, GLint first, GLsizei count) {
    state().draws();
    REAL(glDrawArrays)(mode, first, count);
}

void glDrawElements(GLenum mode, GLsizei count, GLenum type, const void* at) {
    state().draws();
    REAL(glDrawElements)(mode, count, type, at);
}

// Counts living objects.

#define COUNTED(Kind, name)                                                                        \
    void glGen##Kind(GLsizei count, GLuint* names) {                                               \
        state().alive[name] += count;                                                              \
        REAL(glGen##Kind)(count, names);                                                           \
    }                                                                                              \
    void glDelete##Kind(GLsizei count, const GLuint* names) {                                      \
        state().alive[name] -= count;                                                              \
        REAL(glDelete##Kind)(count, names);                                                        \
    }

COUNTED(Buffers, "buffers")
COUNTED(Textures, "textures")
COUNTED(Renderbuffers, "renderbuffers")
COUNTED(Framebuffers, "framebuffers")

GLuint glCreateShader(GLenum stage) {
    ++state().alive["shaders"];
    return REAL(glCreateShader)(stage);
}

void glDeleteShader(GLuint shader) {
    --state().alive["shaders"];
    REAL(glDeleteShader)(shader);
}

GLuint glCreateProgram() {
    ++state().alive["programs"];
    return REAL(glCreateProgram)();
}

void glDeleteProgram(GLuint program) {
    --state().alive["programs"];
    REAL(glDeleteProgram)(program);
}

} // extern "C"
