// Contexts without a window live beside each other and beside the application's.
#include "src/gl/headless_context.hpp"

#include <array>
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES2/gl2.h>
#include <gtest/gtest.h>
#include <memory>

namespace edgeshade {
namespace {

using Color = std::array<std::uint8_t, 3>;
constexpr Color red = {255, 0, 0}, green = {0, 255, 0};

void clear(const Color& color) {
    glClearColor(color[0] / 255.0f, color[1] / 255.0f, color[2] / 255.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

Color colorOf(const gl::HeadlessContext& context) {
    const auto pixels = context.readPixels();
    return {pixels[0], pixels[1], pixels[2]};
}

std::unique_ptr<gl::HeadlessContext> contextOf(int samples = 0) {
    return std::make_unique<gl::HeadlessContext>(
        gl::HeadlessContext::Request{.width = 8, .height = 8, .samples = samples});
}

/// A context of the application on Mesa's display without a surface. Null: it can't be had.
struct ApplicationContext {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ApplicationContext() {
        const auto byPlatform = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
            eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (byPlatform)
            display = byPlatform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (!display || !eglInitialize(display, nullptr, nullptr)) return;
        const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES2_BIT, EGL_SURFACE_TYPE,
                                 EGL_PBUFFER_BIT, EGL_NONE};
        const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglBindAPI(EGL_OPENGL_ES_API);
        if (eglChooseConfig(display, wanted, &config, 1, &count) && count > 0)
            context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
        if (context) eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    }
    ~ApplicationContext() {
        if (!display) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglTerminate(display);
    }
};

} // namespace

TEST(HeadlessContext, LeavesTheOneBeforeItCurrent) {
    const auto first = contextOf();
    clear(red);
    {
        const auto second = contextOf();
        clear(green);
        EXPECT_EQ(colorOf(*second), green);
    }
    EXPECT_EQ(colorOf(*first), red);
}

TEST(HeadlessContext, OutlivesTheOneBeforeIt) {
    auto first = contextOf(4);
    const auto second = contextOf();
    clear(green);
    first.reset();
    EXPECT_EQ(colorOf(*second), green);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(HeadlessContext, LeavesNothingCurrentIfTheOneBeforeItIsGone) {
    auto first = contextOf();
    auto second = contextOf();
    first.reset();
    second.reset();
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(HeadlessContext, LeavesTheApplicationsCurrentAndItsDisplayOpen) {
    const ApplicationContext application;
    if (!application.context || eglGetCurrentContext() != application.context)
        GTEST_SKIP() << "Here the application can't have a context without a surface.";
    contextOf();
    EXPECT_EQ(eglGetCurrentContext(), application.context);
    EXPECT_NE(eglQueryString(application.display, EGL_VERSION), nullptr);
    EXPECT_NE(glGetString(GL_VERSION), nullptr);
}

} // namespace edgeshade
