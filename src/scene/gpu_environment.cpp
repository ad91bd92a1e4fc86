#include "src/scene/gpu_environment.hpp"

#include <GLES2/gl2.h>

namespace edgeshade {

GpuEnvironment::GpuEnvironment(const Environment& environment)
    : diffuse_(environment.diffuse), largestRoot_(environment.specular.largestRoot()),
      atlas_(gl::makeTexture(environment.specular.rgba(), Atlas::width(), Atlas::height(),
                             {GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_LINEAR, GL_LINEAR})) {}

void GpuEnvironment::bind(const gl::Program& program, int unit) const {
    program.setTexture("u_environment", unit, atlas_.name());
    program.set("u_environmentRoot", largestRoot_);
    program.set("u_environmentSh[0]", diffuse_);
}

} // namespace edgeshade
