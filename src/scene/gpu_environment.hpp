#pragma once

#include "src/environment/environment.hpp"
#include "src/gl/objects.hpp"
#include "src/gl/program.hpp"

namespace edgeshade {

/// An environment on the GPU.
class GpuEnvironment {
  public:
    /// Throws Error(unavailable) if the GL can't.
    explicit GpuEnvironment(const Environment& environment);

    /// Sets the uniforms of shaders_es2/environment.glsl; the program must be in use. Binds the
    /// atlas to this texture unit, and leaves that active.
    void bind(const gl::Program& program, int unit) const;

  private:
    DiffuseCoefficients diffuse_;
    float largestRoot_;
    gl::Texture atlas_;
};

} // namespace edgeshade
