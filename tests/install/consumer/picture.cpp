#include "picture.hpp"

#include <cmath>
#include <fstream>
#include <GLES2/gl2.h>
#include <iterator>
#include <vector>

namespace {

constexpr int width = pictureWidth, height = pictureHeight;

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

/// From (4, 5, 6) towards (0, 0.5, 0), with a vertical field of view of 45 degrees.
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

} // namespace

void drawPicture(edgeshade::ShadowMasks::LookUp lookUp) {
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
    edgeshade::ShadowMasks masks(lookUp);
    masks.add({positions, indices});
    edgeshade::MaskLight light;
    light.kind = edgeshade::MaskLight::Kind::point;
    light.position = {1, 5, 2};
    masks.draw(view(), {&light, 1});
    drawWith(program, view(), masks.textures()[0]);
}

void writePicture(const char* path) {
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
