#pragma once

#include "src/gl/instancing.hpp"
#include "src/rivals/published/shadow_buffers.hpp"
#include "src/rivals/published/volume_program.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Draws the sides of shadow volumes. The caller's state decides the effect on the stencil.
class SidesPass {
  public:
    /// `instancing` is required unless the layout is notInstanced. `defines`: for the shaders, see
    /// sides.frag.
    SidesPass(MultiplicityMethod method, SidesLayout layout,
              std::optional<gl::Instancing> instancing, std::vector<std::string> defines = {});

    /// Makes the program for records of that multiplicity, if it is missing.
    void prepare(int maxMultiplicity);

    /// Returns that program, in use.
    const gl::Program& use(int maxMultiplicity) const;

    /// Draws a batch's sides with the program for its multiplicity, which must be in use.
    void draw(const ShadowBuffers& shadow) const;

  private:
    void drawRecords(const ShadowBuffers& shadow, const RecordChunk& chunk) const;

    MultiplicityMethod method_;
    SidesLayout layout_;
    std::optional<gl::Instancing> instancing_;
    std::vector<std::string> defines_;
    gl::Buffer corners_;                  ///< (v, s) of every vertex of a record
    std::map<int, gl::Program> programs_; ///< by maxMultiplicity
};

} // namespace edgeshade
