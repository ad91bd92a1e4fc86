// Casters projected onto a plane by the light. ALPHA_TEST: alpha-tested materials.
#include "rivals/planar/projected.glsl"

attribute vec3 a_position;
#ifdef ALPHA_TEST
attribute vec2 a_texcoord;
attribute vec4 a_color;

varying vec2 v_texcoord;
varying float v_alphaLookup;
#endif

void main() {
#ifdef ALPHA_TEST
    v_texcoord = a_texcoord;
    v_alphaLookup = a_color.a;
#endif
    emitProjected(a_position);
}
