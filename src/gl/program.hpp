#pragma once

#include "src/gl/objects.hpp"

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::gl {

/// A linked program with a vertex and a fragment stage in GLSL ES 1.00.
class Program {
  public:
    /// Compiles and links; in browsers only begins to, so that their compilers work meanwhile.
    /// `defines` are prepended to both stages, "NAME" or "NAME VALUE". Attributes get their index
    /// in `attributes` as location; a variant may lack some of them. Throws Error(unavailable) with
    /// the GL's log; in browsers finish() does.
    Program(const char* vertexSource, const char* fragmentSource,
            const std::vector<std::string>& defines, const std::vector<std::string>& attributes);

    /// Whether finish() was called.
    bool isFinished() const { return !stages_; }
    /// Whether it is compiled and linked, or can't be. Waits for nothing. The GL must have
    /// GL_KHR_parallel_shader_compile.
    bool isCompleted() const;
    /// Waits until it is linked, and in browsers for all earlier drawing, too. Does nothing if it
    /// was called before.
    void finish() const;
    /// Calls finish(), then puts the program into use.
    void use() const;

    // Sets a uniform; does nothing if the variant lacks it. The program must be in use.
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const glm::vec2& value) const;
    void set(const char* uniform, const glm::vec3& value) const;
    void set(const char* uniform, const glm::vec4& value) const;
    /// Sets an array; `uniform` ends with "[0]".
    void set(const char* uniform, std::span<const glm::vec3> values) const;
    void set(const char* uniform, std::span<const glm::vec4> values) const;
    void set(const char* uniform, const glm::mat3& value) const;
    void set(const char* uniform, const glm::mat4& value) const;
    /// Binds a texture to the unit, and has the sampler read it.
    void setTexture(const char* sampler, int unit, Name texture) const;
    void setCube(const char* sampler, int unit, Name cubeMap) const;

  private:
    /// The shaders of a program whose status wasn't queried yet.
    struct Stages {
        ShaderObject vertex, fragment;
    };

    int location(const char* uniform) const;
    void bind(unsigned target, const char* sampler, int unit, Name texture) const;

    ProgramObject object_;
    // Known once it is finished, which use() may do.
    mutable std::optional<Stages> stages_;                      ///< null: it is finished
    mutable std::map<std::string, int, std::less<>> locations_; ///< of the uniforms it has
};

/// Called with each of an object's programs.
using ProgramVisitor = std::function<void(const Program&)>;

} // namespace edgeshade::gl
