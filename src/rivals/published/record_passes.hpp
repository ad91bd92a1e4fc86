#pragma once

#include "src/gl/instancing.hpp"
#include "src/gl/program_variants.hpp"
#include "src/rivals/published/shadow_buffers.hpp"
#include "src/rivals/published/volume_program.hpp"

#include <optional>

namespace edgeshade {

/// Draws the sides and caps of shadow volumes from opposite-vertex records. The
/// caller's state decides the effect on the stencil.
class RecordPasses {
  public:
    /// `instancing` is required unless the layout is notInstanced. `defines`: for the shaders, see
    /// sides.frag and caps.frag.
    RecordPasses(MultiplicityMethod method, SidesLayout layout,
                 std::optional<gl::Instancing> instancing, std::vector<std::string> defines = {});

    /// Makes a program, if it is missing: for sides of records of that multiplicity, for caps.
    void prepareSides(int maxMultiplicity);
    void prepareCaps(const CapsVariant& variant);

    /// Returns that program, in use.
    const gl::Program& useSides(int maxMultiplicity) const { return sides_.use(maxMultiplicity); }
    const gl::Program& useCaps(const CapsVariant& variant) const { return caps_.use(variant); }

    /// Draws a batch's sides with the program for its multiplicity, which must be in use.
    void drawSides(const ShadowBuffers& shadow) const;

    /// Draws some caps of a batch with the program in use. `alphaTested`: that program tests alpha.
    void drawCaps(const ShadowBuffers& shadow, const RecordRange& caps, bool alphaTested) const;

  private:
    void drawChunk(const ShadowBuffers& shadow, const RecordChunk& chunk) const;

    MultiplicityMethod method_;
    SidesLayout layout_;
    std::optional<gl::Instancing> instancing_;
    std::vector<std::string> defines_;
    gl::Buffer
        corners_; ///< (v, s) of every vertex of a record's sides; a cap has those of the first
    gl::ProgramVariants<int> sides_; ///< by maxMultiplicity
    gl::ProgramVariants<CapsVariant> caps_;
};

} // namespace edgeshade
