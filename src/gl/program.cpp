#include "src/gl/program.hpp"

#include "preprocess/base/error.hpp"
#include "src/gl/platform.hpp"

#include <GLES2/gl2.h>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

namespace edgeshade::gl {
namespace {

/// Throws with the GL's log, if it has one; a recorded GL error takes precedence.
[[noreturn]] void refuse(const std::string& sentence, const char* log) {
    requireNoError("making a program");
    const std::string reason = clauseOf(log);
    throw Error(ExitStatus::unavailable,
                sentence + (reason.empty() ? " and gives no reason." : ": " + reason + "."));
}

/// Begins to compile a shader. Whether it does is only asked if the program can't be linked: each
/// question waits until the GL is done, so that it can't compile both stages at once.
ShaderObject compile(GLenum stage, const char* source, const std::vector<std::string>& defines) {
    std::string text = "#version 100\n";
    for (const std::string& define : defines)
        text += "#define " + define + "\n";
    text += source;
    ShaderObject shader(glCreateShader(stage));
    const char* pointer = text.c_str();
    glShaderSource(shader.name(), 1, &pointer, nullptr);
    glCompileShader(shader.name());
    return shader;
}

/// Throws if a shader wasn't compiled; `stage`: its name.
void requireCompiled(const ShaderObject& shader, const std::string& stage) {
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return;
    char log[4096] = "";
    glGetShaderInfoLog(shader.name(), sizeof log, nullptr, log);
    refuse("This GL can't compile a " + stage + " shader", log);
}

} // namespace

Program::Program(const char* vertexSource, const char* fragmentSource,
                 const std::vector<std::string>& defines,
                 const std::vector<std::string>& attributes) {
    stages_ = Stages{compile(GL_VERTEX_SHADER, vertexSource, defines),
                     compile(GL_FRAGMENT_SHADER, fragmentSource, defines)};
    object_ = ProgramObject(glCreateProgram());
    glAttachShader(object_.name(), stages_->vertex.name());
    glAttachShader(object_.name(), stages_->fragment.name());
    for (GLuint i = 0; i < attributes.size(); ++i)
        glBindAttribLocation(object_.name(), i, attributes[i].c_str());
    glLinkProgram(object_.name());
    if (!inBrowser) finish();
}

bool Program::isCompleted() const {
    constexpr GLenum completionStatus = 0x91B1; // GL_COMPLETION_STATUS_KHR
    if (!stages_) return true;
    GLint completed = GL_FALSE;
    glGetProgramiv(object_.name(), completionStatus, &completed);
    return completed == GL_TRUE;
}

void Program::finish() const {
    if (!stages_) return;
    const Stages stages = *std::exchange(stages_, {});
    GLint linked = GL_FALSE;
    glGetProgramiv(object_.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        requireCompiled(stages.vertex, "vertex");
        requireCompiled(stages.fragment, "fragment");
        char log[4096] = "";
        glGetProgramInfoLog(object_.name(), sizeof log, nullptr, log);
        refuse("This GL can't link a program", log);
    }
    GLint uniforms = 0;
    glGetProgramiv(object_.name(), GL_ACTIVE_UNIFORMS, &uniforms);
    for (GLint i = 0; i < uniforms; ++i) {
        char name[256] = ""; // the longest identifier that GLSL ES 1.00 allows
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(object_.name(), static_cast<GLuint>(i), sizeof name, nullptr, &size,
                           &type, name);
        locations_.emplace(name, glGetUniformLocation(object_.name(), name));
    }
}

void Program::use() const {
    finish();
    glUseProgram(object_.name());
}

int Program::location(const char* uniform) const {
    const auto found = locations_.find(uniform);
    return found != locations_.end() ? found->second : -1;
}

void Program::set(const char* uniform, float value) const {
    glUniform1f(location(uniform), value);
}

void Program::set(const char* uniform, const glm::vec2& value) const {
    glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::vec3& value) const {
    glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::vec4& value) const {
    glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, std::span<const glm::vec3> values) const {
    if (values.empty()) return;
    glUniform3fv(location(uniform), static_cast<GLsizei>(values.size()),
                 glm::value_ptr(values.front()));
}

void Program::set(const char* uniform, std::span<const glm::vec4> values) const {
    if (values.empty()) return;
    glUniform4fv(location(uniform), static_cast<GLsizei>(values.size()),
                 glm::value_ptr(values.front()));
}

void Program::set(const char* uniform, const glm::mat3& value) const {
    glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::bind(unsigned target, const char* sampler, int unit, Name texture) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(target, texture);
    glUniform1i(location(sampler), unit);
}

void Program::setTexture(const char* sampler, int unit, Name texture) const {
    bind(GL_TEXTURE_2D, sampler, unit, texture);
}

void Program::setCube(const char* sampler, int unit, Name cubeMap) const {
    bind(GL_TEXTURE_CUBE_MAP, sampler, unit, cubeMap);
}

} // namespace edgeshade::gl
