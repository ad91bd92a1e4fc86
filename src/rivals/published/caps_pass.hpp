#pragma once

#include "src/gl/instancing.hpp"
#include "src/rivals/published/shadow_buffers.hpp"
#include "src/rivals/published/volume_program.hpp"

#include <map>
#include <optional>

namespace edgeshade {

/// Draws the caps of shadow volumes. The caller's state decides the effect on the stencil.
class CapsPass {
  public:
    /// `instancing` is required unless the layout is notInstanced. `defines`: for the shaders, see
    /// caps.frag.
    CapsPass(MultiplicityMethod method, SidesLayout layout,
             std::optional<gl::Instancing> instancing, std::vector<std::string> defines = {});

    /// Makes the program of a variant, if it is missing.
    void prepare(const CapsVariant& variant);

    /// Returns the program of a variant, in use.
    const gl::Program& use(const CapsVariant& variant) const;

    /// Draws some caps of a batch with the program in use. `alphaTested`: that program tests alpha.
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
