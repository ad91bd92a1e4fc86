#pragma once

#include "src/gl/instancing.hpp"
#include "src/rivals/published/shadow_buffers.hpp"
#include "src/rivals/published/volume_program.hpp"

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

    /// Makes the program of a variant, if it is not there yet.
    void prepare(const CapsVariant& variant);

    /// The program of such a variant, in use.
    const gl::Program& use(const CapsVariant& variant) const;

    /// Draws some caps of a batch by the program that is in use. `alphaTested`: it tests alpha.
    void draw(const ShadowBuffers& shadow, const RecordRange& caps, bool alphaTested) const;

  private:
    MultiplicityMethod method_;
    SidesLayout layout_;
    std::optional<gl::Instancing> instancing_;
    std::vector<std::string> defines_;
    gl::Buffer corners_; ///< v of the six vertices of a record
    std::map<CapsVariant, gl::Program> programs_;
};

} // namespace edgeshade
