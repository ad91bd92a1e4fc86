#include "tests/engine/host_picture.hpp"

#include <GLES2/gl2.h>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

constexpr char vertexStage[] = R"(
attribute highp vec3 position;
attribute highp vec3 normal;
uniform highp mat4 viewFromObject, clipFromView;
varying highp vec3 v_place, v_normal;
void main() {
    highp vec4 place = viewFromObject * vec4(position, 1.0);
    v_place = place.xyz;
    v_normal = mat3(viewFromObject[0].xyz, viewFromObject[1].xyz, viewFromObject[2].xyz) * normal;
    gl_Position = clipFromView * place;
})";

constexpr char fragmentStage[] = R"(
uniform highp vec4 cone; // axis in the view, cosine of its angle
uniform highp vec3 apex;
uniform bool casts;
varying highp vec3 v_place, v_normal;
void main() {
    highp vec3 lit = ASKED;
    if (cone.w > -1.0 && dot(normalize(v_place - apex), cone.xyz) < cone.w) lit = vec3(0.0);
    gl_FragColor = vec4(lit, 1.0);
})";

constexpr char modern[] = "#version 300 es\n";
constexpr char modernVertex[] = "#define attribute in\n#define varying out\n";
constexpr char modernFragment[] = "#define varying in\n#define gl_FragColor colour\n"
                                  "out highp vec4 colour;\n";

gl::Name compiled(GLenum stage, const std::string& source) {
    const gl::Name shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    std::string log(4096, '\0');
    if (!done) glGetShaderInfoLog(shader, 4096, nullptr, log.data());
    EXPECT_TRUE(done) << log;
    return shader;
}

std::string fragmentSource(HostPicture::Language language) {
    std::string asks = language.casters.tints ? "sun_litColor"
                       : language.soft        ? "sun_litShare"
                                              : "sun_lit";
    asks += language.version3 || language.derivatives
                ? "(v_place, -v_place, casts)"
                : "On(v_place, -v_place, v_normal, 16.0, casts)";
    if (language.soft)
        asks = "vec3(" + asks + ")";
    else if (!language.casters.tints)
        asks = "vec3(" + asks + " ? 1.0 : 0.0)";
    std::string source = "precision mediump float;\n";
    if (language.version3)
        source = modern + source + modernFragment;
    else if (language.derivatives)
        source = "#extension GL_OES_standard_derivatives : enable\n"
                 "#define EDGESHADE_DERIVATIVES\n" +
                 source;
    // Two lights in one shader have separate names.
    source += lookupSource("sun", language.casters, language.soft) + lookupSource("other_lamp");
    return source + "#define ASKED " + asks + "\n" + fragmentStage;
}

GLint placeOf(const gl::ProgramObject& program, const char* name) {
    return glGetUniformLocation(program.name(), name);
}

void setMatrix(const gl::ProgramObject& program, const char* name, const glm::mat4& matrix) {
    glUniformMatrix4fv(placeOf(program, name), 1, GL_FALSE, glm::value_ptr(matrix));
}

} // namespace

HostPicture::HostPicture(const ShadowMasks& masks, ShadowMasks::LookupId lookup,
                         const MaskLight& light, const MaskView& view, Language language)
    : program_(glCreateProgram()), view_(view) {
    const std::string start = language.version3 ? std::string(modern) + modernVertex : "";
    const gl::ShaderObject vertex(compiled(GL_VERTEX_SHADER, start + vertexStage));
    const gl::ShaderObject fragment(compiled(GL_FRAGMENT_SHADER, fragmentSource(language)));
    glAttachShader(program_.name(), vertex.name());
    glAttachShader(program_.name(), fragment.name());
    glBindAttribLocation(program_.name(), 0, "position");
    glBindAttribLocation(program_.name(), 1, "normal");
    glLinkProgram(program_.name());
    glUseProgram(program_.name());
    const LightLookup& told = masks.lookup(lookup);
    EXPECT_EQ(told.why, "");
    EXPECT_TRUE(told.uploaded);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, told.texture);
    glUniform1i(placeOf(program_, "sun_table"), 0);
    glUniform3fv(placeOf(program_, "sun_tableSize"), 1, told.tableSize.data());
    glUniform2fv(placeOf(program_, "sun_begins"), 1, told.begins.data());
    glUniform1f(placeOf(program_, "sun_size"), told.size);
    glUniform1f(placeOf(program_, "sun_kind"), told.kind);
    glUniform2fv(placeOf(program_, "sun_places"), 1, told.places.data());
    setMatrix(program_, "sun_mapFromHost",
              glm::make_mat4(mapFromView(told, view.viewFromWorld).data()));
    const glm::dmat4 viewFromWorld = glm::make_mat4(view.viewFromWorld.data());
    const auto seen = [&](const std::array<double, 3>& of, double w) {
        return glm::vec3(viewFromWorld * glm::dvec4(of[0], of[1], of[2], w));
    };
    const glm::vec3 apex = seen(light.position, 1.0);
    const glm::vec3 axis = glm::normalize(seen(light.direction, 0.0));
    const bool isSpot = light.kind == MaskLight::Kind::spot;
    glUniform3fv(placeOf(program_, "apex"), 1, glm::value_ptr(apex));
    glUniform4f(placeOf(program_, "cone"), axis.x, axis.y, axis.z,
                isSpot ? static_cast<float>(std::cos(light.outerAngle)) : -1.0f);
    glViewport(0, 0, view.width, view.height);
    glEnable(GL_DEPTH_TEST);
    glClearColor(1.0f, 1.0f, 1.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

HostPicture::~HostPicture() {
    glUseProgram(0); // otherwise, once deleted, it lives until another is used
}

void HostPicture::draw(const Geometry& geometry, const Matrix16& worldFromObject, bool casts) {
    std::vector<glm::vec3> corners; // alternately with the normals of their triangles
    for (std::size_t i = 0; i < geometry.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return geometry.positions[geometry.indices[i + k]]; };
        const glm::vec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
        for (const std::size_t k : {0u, 1u, 2u})
            corners.insert(corners.end(), {at(k), normal});
    }
    glUseProgram(program_.name());
    setMatrix(program_, "viewFromObject",
              glm::mat4(glm::make_mat4(view_.viewFromWorld.data()) *
                        glm::make_mat4(worldFromObject.data())));
    setMatrix(program_, "clipFromView", glm::mat4(glm::make_mat4(view_.clipFromView.data())));
    glUniform1i(placeOf(program_, "casts"), casts);
    gl::Name buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(glm::vec3)),
                 corners.data(), GL_STATIC_DRAW);
    for (const GLuint attribute : {0u, 1u}) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 24,
                              reinterpret_cast<const void*>(std::uintptr_t{12} * attribute));
    }
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / 2));
    for (const GLuint attribute : {0u, 1u})
        glDisableVertexAttribArray(attribute);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDeleteBuffers(1, &buffer);
}

Wrong compared(const Mask& mask, const Mask& expected) {
    Wrong wrong;
    for (int y = 0; y < hostHeight; ++y)
        for (int x = 0; x < hostWidth; ++x) {
            const auto at = static_cast<std::size_t>(y * hostWidth + x);
            if (mask[at] == expected[at]) continue;
            ++wrong.all;
            wrong.beyond += !isAtBorder(expected, x, y);
        }
    return wrong;
}

std::vector<HostPicture::Language> languages(const gl::Capabilities& has, LookupCasters casters) {
    std::vector<HostPicture::Language> known = {{false, true, casters}, {false, false, casters}};
    if (has.version.starts_with("OpenGL ES 3")) known.push_back({true, true, casters});
    return known;
}

std::vector<glm::dvec3> pointsOfGround(const MaskView& view) {
    const glm::dmat4 worldFromView = glm::inverse(glm::make_mat4(view.viewFromWorld.data()));
    const glm::dmat4 viewFromClip = glm::inverse(glm::make_mat4(view.clipFromView.data()));
    const glm::dvec3 eye(worldFromView[3]);
    std::vector<glm::dvec3> points;
    for (int y = 0; y < hostHeight; ++y)
        for (int x = 0; x < hostWidth; ++x) {
            const glm::dvec4 end =
                viewFromClip * glm::dvec4(2.0 * (x + 0.5) / hostWidth - 1.0,
                                          1.0 - 2.0 * (y + 0.5) / hostHeight, 0.5, 1.0);
            const glm::dvec3 along =
                glm::dvec3(worldFromView * glm::dvec4(glm::dvec3(end) / end.w, 1.0)) - eye;
            points.push_back(eye - eye.y / along.y * along);
        }
    return points;
}

Mask redOf(const gl::HeadlessContext& context) {
    const std::vector<std::uint8_t> rgba = context.readPixels();
    Mask mask;
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        mask.push_back(rgba[i]);
    return mask;
}

ShadowMasks::LookupId lookedUp(ShadowMasks& masks, const MaskLight& light,
                               const LookupSettings& settings) {
    LookupWork work = masks.lookupWork(light, settings);
    work.finish();
    const auto id = masks.addLookup(work);
    while (!masks.uploadLookup(id, 100000)) { // in pieces
    }
    return id;
}

} // namespace edgeshade::test
