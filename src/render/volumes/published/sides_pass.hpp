#pragma once

#include "src/gl/instancing.hpp"
#include "src/render/volumes/published/volume_program.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Draws the sides of shadow volumes; what they do to the stencil is the caller's state.
class SidesPass {
  public:
    /// `instancing` must be there unless the layout is notInstanced. `defines`: of the shaders, see
    /// sides.frag.
    SidesPass(MultiplicityMethod method, SidesLayout layout,
              std::optional<gl::Instancing> instancing, std::vector<std::string> defines = {});

    /// Draws one batch. `light` and `clipFromObject` are in the batch's space.
    void draw(const ShadowBuffers& shadow, const glm::vec4& light, const glm::mat4& clipFromObject);

  private:
    void drawRecords(gl::Program& program, const ShadowBuffers& shadow, const RecordChunk& chunk);

    MultiplicityMethod method_;
    SidesLayout layout_;
    std::optional<gl::Instancing> instancing_;
    std::vector<std::string> defines_;
    gl::Buffer corners_;                  ///< (v, s) of every vertex of a record
    std::map<int, gl::Program> programs_; ///< by maxMultiplicity
};

} // namespace edgeshade
