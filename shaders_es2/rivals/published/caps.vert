// Caps of the shadow volumes: one record per triangle A < B < C, front cap then back cap
// (docs/method.md, Records and caps, as published; thesis, Algorithm 11).
//
// Variants: INSTANCED as in sides.vert; those of cap_corner.glsl; PROBE, for tests.
#include "record_layout.glsl"
#include "rivals/published/multiplicity.glsl"
#include "cap_corner.glsl"

#ifdef INSTANCED
attribute vec2 a_corner; // x: vertex v of the pair of caps, 0..5
#endif
attribute vec4 a_capA; // when not instanced: w = v
attribute vec4 a_capB;
attribute vec4 a_capC;

uniform vec4 u_light; // in object space

#ifdef PROBE
#include "probe.glsl"
#endif

void main() {
    float facing = triangleSign(a_capA.xyz, a_capB.xyz, a_capC.xyz, u_light);
#ifdef PROBE
    emitProbe(facing);
#else
#ifdef INSTANCED
    float v = a_corner.x;
#else
    float v = a_capA.w;
#endif
    emitCap(v, facing, a_capA.xyz, a_capB.xyz, a_capC.xyz, u_light);
#endif
}
