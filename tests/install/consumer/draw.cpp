// draw OUT.ppm: a box over a floor, by a shader of its own in a context of its own, in the shadow
// that edgeshade's mask says. In shadow 51 of 255, lit 204, behind everything blue.
#include <edgeshade/shadow_masks.hpp>

#include <cmath>
#include <cstdio>
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <exception>
#include <fstream>
#include <GLES2/gl2.h>
#include <iostream>
#include <vector>

namespace {

constexpr int width = 320, height = 240;

constexpr float positions[] = {
    -4,   0,    4,    4,   0,    4,    4,    0,   -4,   -4,  0,   -4,   // the floor
    -0.5, 0.5f, -0.5, 0.5, 0.5f, -0.5, -0.5, 1.5, -0.5, 0.5, 1.5, -0.5, // the box
    -0.5, 0.5f, 0.5,  0.5, 0.5f, 0.5,  -0.5, 1.5, 0.5,  0.5, 1.5, 0.5};
constexpr std::uint32_t indices[] = {0,  1, 2,  0, 2, 3, 4, 8, 10, 4, 10, 6,  5,  7,
                                     11, 5, 11, 9, 4, 5, 9, 4, 9,  8, 6,  10, 11, 6,
                                     11, 7, 4,  6, 7, 4, 7, 5, 8,  9, 11, 8,  11, 10};

constexpr const char* vertexText = R"(
attribute vec3 a_position;
uniform mat4 u_clipFromWorld;
void main() { gl_Position = u_clipFromWorld * vec4(a_position, 1.0); })";
constexpr const char* fragmentText = R"(
precision mediump float;
uniform sampler2D u_mask;
uniform vec2 u_size;
void main() { gl_FragColor = vec4(vec3(0.2 + 0.6 * texture2D(u_mask, gl_FragCoord.xy / u_size).r), 1.0); })";

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
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglBindAPI(EGL_OPENGL_ES_API);
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return false;
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    return eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
}

GLuint compiled(GLenum kind, const char* text) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    return shader;
}

GLuint makeProgram() {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, vertexText));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragmentText));
    glBindAttribLocation(program, 0, "a_position");
    glLinkProgram(program);
    return program;
}

/// From (4, 5, 6) towards (0, 0.5, 0), 45 degrees high.
edgeshade::MaskView view() {
    const double from[] = {4, 5, 6}, to[] = {0, 0.5, 0};
    double z[3], x[3], y[3];
    const double length = std::hypot(from[0] - to[0], from[1] - to[1], from[2] - to[2]);
    for (int i = 0; i < 3; ++i)
        z[i] = (from[i] - to[i]) / length;
    const double level = std::hypot(z[0], z[2]);
    x[0] = z[2] / level, x[1] = 0.0, x[2] = -z[0] / level;
    y[0] = z[1] * x[2] - z[2] * x[1], y[1] = z[2] * x[0] - z[0] * x[2];
    y[2] = z[0] * x[1] - z[1] * x[0];
    const auto shift = [&](const double* axis) {
        return -(axis[0] * from[0] + axis[1] * from[1] + axis[2] * from[2]);
    };
    const double focal = 1.0 / std::tan(std::acos(-1.0) / 8.0), low = 0.1, high = 100.0;
    edgeshade::MaskView of;
    of.viewFromWorld = {x[0], y[0], z[0], 0, x[1],     y[1],     z[1],     0,
                        x[2], y[2], z[2], 0, shift(x), shift(y), shift(z), 1};
    of.clipFromView = {focal * height / width,
                       0,
                       0,
                       0,
                       0,
                       focal,
                       0,
                       0,
                       0,
                       0,
                       (low + high) / (low - high),
                       -1,
                       0,
                       0,
                       2 * low * high / (low - high),
                       0};
    of.width = width;
    of.height = height;
    return of;
}

edgeshade::Matrix16 product(const edgeshade::Matrix16& a, const edgeshade::Matrix16& b) {
    edgeshade::Matrix16 of{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t i = 0; i < 4; ++i)
                of[4 * column + row] += a[4 * i + row] * b[4 * column + i];
    return of;
}

void drawWith(GLuint program, const edgeshade::MaskView& seen, GLuint mask) {
    float clipFromWorld[16];
    const edgeshade::Matrix16 whole = product(seen.clipFromView, seen.viewFromWorld);
    for (std::size_t i = 0; i < 16; ++i)
        clipFromWorld[i] = static_cast<float>(whole[i]);
    glClearColor(0.0f, 0.0f, 1.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "u_clipFromWorld"), 1, GL_FALSE,
                       clipFromWorld);
    glUniform2f(glGetUniformLocation(program, "u_size"), width, height);
    glBindTexture(GL_TEXTURE_2D, mask);
    glDrawElements(GL_TRIANGLES, std::size(indices), GL_UNSIGNED_BYTE, nullptr);
}

void write(const char* path) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width << " " << height << "\n255\n";
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            file.write(
                reinterpret_cast<const char*>(&rgba[4 * (std::size_t(y) * width + std::size_t(x))]),
                3);
}

} // namespace

int main(int, char** words) {
    if (!makeContext()) {
        std::cerr << "No ES 2.0 context can be had here.\n";
        return 3;
    }
    const GLuint program = makeProgram();
    std::vector<std::uint8_t> corners(std::begin(indices), std::end(indices));
    GLuint buffers[2];
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof(positions), positions, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size()), corners.data(),
                 GL_STATIC_DRAW);
    glEnable(GL_DEPTH_TEST);
    try {
        edgeshade::ShadowMasks masks(
            [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); });
        masks.add({positions, indices});
        edgeshade::MaskLight light;
        light.kind = edgeshade::MaskLight::Kind::point;
        light.position = {1, 5, 2};
        masks.draw(view(), {&light, 1});
        drawWith(program, view(), masks.textures()[0]);
        write(words[1]);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
