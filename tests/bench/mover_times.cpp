// A frame with a figure that walks over a lookup, beside the frame at rest: `mover_times SCENE...`
// prints JSON, in milliseconds of the fastest frame. The host draws the scene with a shader that
// samples the light's lookup and, while the figure walks, the mask of its movers.
#include "edgeshade/shadow_masks.hpp"
#include "preprocess/base/stopwatch.hpp"
#include "src/bench/flythrough.hpp"
#include "src/gl/headless_context.hpp"
#include "src/scene/load.hpp"
#include "src/shadow/view/frustum.hpp"
#include "tests/bench/egl_host.hpp"
#include "tests/bench/told_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <GLES2/gl2.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int frames = 40, width = 1280, height = 720;

/// Triangles on the CPU.
struct Shape {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;

    MaskMesh mesh() const { return {{&positions[0].x, 3 * positions.size()}, indices}; }
};

/// A closed tube with rounded ends.
void addLimb(Shape& to, const glm::vec3& top, const glm::vec3& foot, float radius) {
    constexpr std::uint32_t around = 16, along = 16;
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (std::uint32_t j = 0; j <= along; ++j)
        for (std::uint32_t i = 0; i < around; ++i) {
            const float share = static_cast<float>(j) / along;
            const float turn = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / around;
            const float wide = radius * std::sqrt(share * (1.0f - share));
            to.positions.push_back(glm::mix(top, foot, share) +
                                   wide * glm::vec3(std::cos(turn), 0.0f, std::sin(turn)));
        }
    for (std::uint32_t j = 0; j < along; ++j)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = first + around * j + i,
                                b = first + around * j + (i + 1) % around;
            to.indices.insert(to.indices.end(), {a, b, a + around, b, b + around, a + around});
        }
}

/// A figure of 6 limbs, 3,072 triangles, in a step of its walk; as high as 1.
Shape figure(int step) {
    const float swing = 0.15f * std::sin(0.5f * static_cast<float>(step));
    Shape made;
    addLimb(made, {0, 0.86f, 0}, {0, 0.45f, 0}, 0.24f);
    addLimb(made, {0, 1, 0}, {0, 0.87f, 0}, 0.06f);
    for (const float side : {-1.0f, 1.0f}) {
        addLimb(made, {0.07f * side, 0.48f, 0}, {0.07f * side, 0.01f, swing * side}, 0.06f);
        addLimb(made, {0.15f * side, 0.82f, 0}, {0.17f * side, 0.45f, -swing * side}, 0.04f);
    }
    return made;
}

const char* const vertexStage = R"(
attribute highp vec3 position;
uniform highp mat4 viewFromObject, clipFromView;
varying highp vec3 v_place;
void main() {
    highp vec4 place = viewFromObject * vec4(position, 1.0);
    v_place = place.xyz;
    gl_Position = clipFromView * place;
})";

const char* const fragmentStage = R"(
uniform sampler2D masks;
uniform mediump vec2 texel;
uniform highp vec4 region; // of the masks: lower left, upper right; empty without masks
varying highp vec3 v_place;
void main() {
    highp vec3 normal = normalize(cross(dFdx(v_place), dFdy(v_place)));
    mediump float lit = sun_lit(v_place, -v_place, true) ? 1.0 : 0.0;
    for (int i = 0; i < 1; ++i) {
        if (any(lessThan(gl_FragCoord.xy, region.xy)) || any(greaterThan(gl_FragCoord.xy, region.zw))) break;
        lit *= texture2D(masks, gl_FragCoord.xy * texel).r;
    }
    gl_FragColor = vec4(vec3(0.2 + 0.8 * lit * abs(normal.z)), 1.0);
})";

GLuint programOf() {
    const std::string source = "#extension GL_OES_standard_derivatives : enable\n"
                               "#define EDGESHADE_DERIVATIVES\nprecision mediump float;\n" +
                               lookupSource("sun") + fragmentStage;
    const GLuint program = glCreateProgram();
    for (const auto& [stage, text] : {std::pair<GLenum, std::string>{GL_VERTEX_SHADER, vertexStage},
                                      {GL_FRAGMENT_SHADER, source}}) {
        const GLuint shader = glCreateShader(stage);
        const char* start = text.c_str();
        glShaderSource(shader, 1, &start, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glBindAttribLocation(program, 0, "position");
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) throw std::runtime_error("The host's shader doesn't link.");
    return program;
}

/// Meshes of the host on the GPU.
struct HostMesh {
    GLuint positions = 0, indices = 0;
    GLsizei count = 0;
    glm::dmat4 place{1.0};

    void upload(std::span<const glm::vec3> from, std::span<const std::uint32_t> corners) {
        if (positions == 0) glGenBuffers(1, &positions);
        std::vector<glm::vec3> soup;
        for (const std::uint32_t corner : corners)
            soup.push_back(from[corner]);
        count = static_cast<GLsizei>(soup.size());
        glBindBuffer(GL_ARRAY_BUFFER, positions);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(soup.size() * sizeof(glm::vec3)),
                     soup.data(), GL_STATIC_DRAW);
    }
};

struct Host {
    GLuint program = programOf();
    std::vector<HostMesh> meshes;

    GLint at(const char* name) const { return glGetUniformLocation(program, name); }
    void draw(const ShadowMasks& masks, const LightLookup& map, const MaskView& view,
              bool masked) const {
        glUseProgram(program);
        glViewport(0, 0, view.width, view.height);
        glEnable(GL_DEPTH_TEST);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, map.texture);
        glUniform1i(at("sun_table"), 0);
        glUniform3fv(at("sun_tableSize"), 1, map.tableSize.data());
        glUniform2fv(at("sun_begins"), 1, map.begins.data());
        glUniform1f(at("sun_size"), map.size);
        glUniform1f(at("sun_kind"), map.kind);
        glUniformMatrix4fv(at("sun_mapFromHost"), 1, GL_FALSE,
                           mapFromView(map, view.viewFromWorld).data());
        const MaskRegion of = masked ? masks.region() : MaskRegion{};
        glUniform4f(at("region"), static_cast<float>(of.x), static_cast<float>(of.y),
                    static_cast<float>(of.x + of.width), static_cast<float>(of.y + of.height));
        glUniform1i(at("masks"), 1);
        glUniform2f(at("texel"), 1.0f / static_cast<float>(view.width),
                    1.0f / static_cast<float>(view.height));
        if (masked) {
            glActiveTexture(GL_TEXTURE1);
            glBindTexture(GL_TEXTURE_2D, masks.textures()[0]);
        }
        glUniformMatrix4fv(at("clipFromView"), 1, GL_FALSE,
                           glm::value_ptr(glm::mat4(glm::make_mat4(view.clipFromView.data()))));
        glEnableVertexAttribArray(0);
        for (const HostMesh& mesh : meshes) {
            const glm::mat4 place(glm::make_mat4(view.viewFromWorld.data()) * mesh.place);
            glUniformMatrix4fv(at("viewFromObject"), 1, GL_FALSE, glm::value_ptr(place));
            glBindBuffer(GL_ARRAY_BUFFER, mesh.positions);
            glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
            glDrawArrays(GL_TRIANGLES, 0, mesh.count);
        }
        glDisableVertexAttribArray(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glFinish();
    }
};

Json measured(const std::string& path) {
    const gl::HeadlessContext context({width, height});
    const LoadedScene loaded = loadScene(path, std::nullopt);
    const Box bounds = worldBounds(loaded.scene);
    ShadowMasks masks(eglAddressOf);
    Host host;
    for (const Batch& batch : loaded.scene.batches) {
        const Geometry& geometry = *batch.geometry;
        if (geometry.indices.empty()) continue;
        masks.add(
            MaskMesh{.positions = {&geometry.positions.data()->x, 3 * geometry.positions.size()},
                     .indices = geometry.indices},
            numbersOf(batch.worldFromBatch));
        HostMesh& mesh = host.meshes.emplace_back();
        mesh.upload(geometry.positions, geometry.indices);
        mesh.place = batch.worldFromBatch;
    }
    MaskLight light;
    light.direction = {-0.5, -1.0, 0.35};
    // Across the scene's middle, a quarter of its height tall.
    const double tall = 0.25 * (bounds.high.y - bounds.low.y);
    const auto placeAt = [&](int step) {
        const double share = static_cast<double>(step) / frames - 0.5;
        glm::dvec3 at = bounds.center();
        at.x += 0.4 * share * (bounds.high.x - bounds.low.x);
        at.y = bounds.low.y + 0.4 * tall;
        return glm::scale(glm::translate(glm::dmat4(1.0), at), glm::dvec3(tall));
    };
    Shape shape = figure(0);
    const auto bent = [&] {
        MaskMesh mesh = shape.mesh();
        mesh.bends = true;
        return mesh;
    };
    const auto walker = masks.add(bent(), numbersOf(placeAt(0)));
    host.meshes.emplace_back();
    const auto walk = [&](int step) {
        shape = figure(step);
        masks.change(walker, bent());
        masks.move(walker, numbersOf(placeAt(step)));
        host.meshes.back().upload(shape.positions, shape.indices);
        host.meshes.back().place = placeAt(step);
    };
    walk(1);
    LookupWork work = masks.lookupWork(light, {.restMs = 1e9});
    work.finish();
    const auto id = masks.addLookup(work);
    masks.uploadLookup(id);
    const LightLookup map = masks.lookup(id);
    if (!map.why.empty()) throw std::runtime_error("No lookup: " + map.why + ".");
    const double aspect = static_cast<double>(width) / height;
    const Frustum frustum =
        frustumOf(Camera{bounds.center() + glm::dvec3(0.35, 0.25, 0.6) * bounds.diagonal(),
                         bounds.center(), 45.0},
                  aspect);
    const MaskView view{.viewFromWorld = numbersOf(frustum.viewFromWorld),
                        .clipFromView = numbersOf(clipFromView(frustum, 0.1, 1e4)),
                        .width = width,
                        .height = height};
    std::vector<double> rest, walking, masked, posing, engine;
    for (int step = 0; step < frames; ++step) { // in turns, so that other load falls on all
        Stopwatch watch;
        host.draw(masks, map, view, false);
        rest.push_back(1e3 * watch.lap());
        walk(step);
        posing.push_back(1e3 * watch.lap());
        masks.draw(view, {&light, 1}, {&id, 1});
        glFinish();
        engine.push_back(1e3 * watch.lap());
        host.draw(masks, map, view, true);
        walking.push_back(posing.back() + engine.back() + 1e3 * watch.lap());
        masks.draw(view, {&light, 1});
        glFinish();
        masked.push_back(1e3 * watch.lap());
    }
    const auto fastest = [](const std::vector<double>& of) {
        return *std::min_element(of.begin(), of.end());
    };
    return {{"scene", std::filesystem::path(path).stem().string()},
            {"rest_ms", fastest(rest)},
            {"walking_ms", fastest(walking)},
            {"ratio", fastest(walking) / fastest(rest)},
            {"posing_ms", fastest(posing)},
            {"movers_mask_ms", fastest(engine)},
            {"whole_mask_ms", fastest(masked)}};
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    return edgeshade::tellOfScenes(count, words, edgeshade::measured);
}
