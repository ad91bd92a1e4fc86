#pragma once

#include "src/gl/objects.hpp"

#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::gl {

/// A linked program with a vertex and a fragment stage in GLSL ES 1.00.
class Program {
  public:
    /// Compiles and links. `defines` are prepended to both stages, "NAME" or "NAME VALUE".
    /// Attributes get their index in `attributes` as location; a variant may lack some of them.
    /// Throws Error(unavailable) with the GL's log.
    Program(const char* vertexSource, const char* fragmentSource,
            const std::vector<std::string>& defines, const std::vector<std::string>& attributes);

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
    int location(const char* uniform) const;
    void bind(unsigned target, const char* sampler, int unit, Name texture) const;

    ProgramObject object_;
    std::map<std::string, int, std::less<>> locations_; ///< of the uniforms it has
};

} // namespace edgeshade::gl
