#include "src/gl/program.hpp"

#include "preprocess/base/error.hpp"

#include <GLES2/gl2.h>
#include <glm/gtc/type_ptr.hpp>

namespace edgeshade::gl {
namespace {

/// With the GL's own words, where it has some; an error that it has recorded says more.
[[noreturn]] void refuse(const std::string& sentence, const char* log) {
    requireNoError("making a program");
    const std::string reason = clauseOf(log);
    throw Error(ExitStatus::unavailable,
                sentence + (reason.empty() ? " and gives no reason." : ": " + reason + "."));
}

ShaderObject compile(GLenum stage, const char* source, const std::vector<std::string>& defines) {
    std::string text = "#version 100\n";
    for (const std::string& define : defines)
        text += "#define " + define + "\n";
    text += source;
    ShaderObject shader(glCreateShader(stage));
    const char* pointer = text.c_str();
    glShaderSource(shader.name(), 1, &pointer, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    char log[4096] = "";
    glGetShaderInfoLog(shader.name(), sizeof log, nullptr, log);
    refuse(std::string("This GL can't compile a ") +
               (stage == GL_VERTEX_SHADER ? "vertex" : "fragment") + " shader",
           log);
}

} // namespace

Program::Program(const char* vertexSource, const char* fragmentSource,
                 const std::vector<std::string>& defines,
                 const std::vector<std::string>& attributes) {
    const ShaderObject vertex = compile(GL_VERTEX_SHADER, vertexSource, defines);
    const ShaderObject fragment = compile(GL_FRAGMENT_SHADER, fragmentSource, defines);
    object_ = ProgramObject(glCreateProgram());
    glAttachShader(object_.name(), vertex.name());
    glAttachShader(object_.name(), fragment.name());
    for (GLuint i = 0; i < attributes.size(); ++i)
        glBindAttribLocation(object_.name(), i, attributes[i].c_str());
    glLinkProgram(object_.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(object_.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    char log[4096] = "";
    glGetProgramInfoLog(object_.name(), sizeof log, nullptr, log);
    refuse("This GL can't link a program", log);
}

void Program::use() const {
    glUseProgram(object_.name());
}

int Program::location(const char* uniform) {
    const auto found = locations_.find(uniform);
    if (found != locations_.end()) return found->second;
    return locations_[uniform] = glGetUniformLocation(object_.name(), uniform);
}

void Program::set(const char* uniform, float value) {
    glUniform1f(location(uniform), value);
}

void Program::set(const char* uniform, const glm::vec2& value) {
    glUniform2fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::vec3& value) {
    glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::vec4& value) {
    glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::mat3& value) {
    glUniformMatrix3fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::set(const char* uniform, const glm::mat4& value) {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::setSampler(const char* uniform, int unit) {
    glUniform1i(location(uniform), unit);
}

} // namespace edgeshade::gl
