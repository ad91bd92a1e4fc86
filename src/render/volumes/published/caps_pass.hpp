#pragma once

#include "src/render/volumes/published/volume_program.hpp"
#include "src/scene/textures.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Draws the caps of shadow volumes; what they do to the stencil is the caller's state.
class CapsPass {
  public:
    /// `instancing` must be there unless the layout is notInstanced. `defines`: of the shaders, see
    /// caps.frag.
    CapsPass(MultiplicityMethod method, SidesLayout layout,
             std::optional<gl::Instancing> instancing, std::vector<std::string> defines = {});

    /// Draws one batch. `light` and `clipFromObject` are in the batch's space. `nearDiscard`: some
    /// caster may cross the near plane.
    void draw(const ShadowBuffers& shadow, const std::vector<Material>& materials,
              const Textures& textures, const glm::vec4& light, const glm::mat4& clipFromObject,
              bool nearDiscard);

  private:
    gl::Program& program(const CapsVariant& variant);
    void drawGroup(const ShadowBuffers& shadow, const CasterGroup& group, bool holes);

    MultiplicityMethod method_;
    SidesLayout layout_;
    std::optional<gl::Instancing> instancing_;
    std::vector<std::string> defines_;
    gl::Buffer corners_; ///< v of the six vertices of a record
    std::map<CapsVariant, gl::Program> programs_;
};

} // namespace edgeshade
