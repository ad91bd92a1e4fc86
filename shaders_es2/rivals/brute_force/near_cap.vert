// A triangle A < B < C projected by the light onto the near plane, to find the pixels there that
// the triangle's volume contains (ZP+, Hornus et al. 2005). The matrix is the picture's own, so
// that pixels of the near plane are those of the picture. INSTANCED as in sides.vert; otherwise
// only the first three vertices are used.
#include "record_layout.glsl"
#include "rivals/published/multiplicity.glsl"
#include "rivals/planar/projected.glsl"

#ifdef INSTANCED
attribute vec2 a_corner; // x: vertex 0..2
#endif
attribute vec4 a_capA; // when not instanced: w = v
attribute vec4 a_capB;
attribute vec4 a_capC;

void main() {
#ifdef INSTANCED
    float v = a_corner.x;
#else
    float v = a_capA.w;
#endif
    emitProjected(v < 0.5 ? a_capA.xyz : v < 1.5 ? a_capB.xyz : a_capC.xyz);
    float facing = triangleSign(a_capA.xyz, a_capB.xyz, a_capC.xyz, u_light);
    if (facing == 0.0 || v > 2.5) gl_Position = vec4(0.0);
}
