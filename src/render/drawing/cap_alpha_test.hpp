#pragma once

#include "src/gl/program.hpp"
#include "src/scene/textures.hpp"

namespace edgeshade {

/// Sets what tells the cutouts of a caster from its solid parts: the uniforms of caps.frag's
/// ALPHA_TEST variant, which must be in use, and the texture of unit 0.
void setCapAlphaTest(const gl::Program& program, const Material& material,
                     const Textures& textures);

} // namespace edgeshade
