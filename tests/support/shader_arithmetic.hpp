#pragma once

// The shaders' own source for signs and multiplicities, compiled as C++: one struct per method. All
// in floats, in GLSL's evaluation order.

#include <glm/glm.hpp>

#include "shaders_es2/record_layout.glsl"

namespace edgeshade::shader_arithmetic {

using glm::clamp;
using glm::sign;
using glm::vec2;
using glm::vec3;
using glm::vec4;

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion" // GLSL's literals are floats, C++'s doubles
#pragma GCC diagnostic ignored "-Wfloat-conversion"

#include "tests/support/shader_methods.inc"

#pragma GCC diagnostic pop

} // namespace edgeshade::shader_arithmetic
