// Caps of the shadow volumes, from records of a triangle and its plane
// (preprocess/volumes/plane_pair_data.hpp).
//
// Variants: those of cap_corner.glsl; CULLED, front caps alone, in place, of triangles that show
// their backs to u_eye (docs/method.md, C39); PROBE, for tests.
#include "plane_side.glsl"
#include "cap_corner.glsl"

attribute float a_corner; // 0..2: the front cap, 3..5: the back cap
attribute vec3 a_capA;    // counter-clockwise
attribute vec3 a_capB;
attribute vec3 a_capC;
attribute vec4 a_plane;

uniform vec4 u_light;   // in object space
uniform float u_reach;  // see planeSide()
uniform vec2 u_counted; // see countedSide()
#ifdef CULLED
uniform vec4 u_eye; // in object space, homogeneous
#endif

#ifdef PROBE
#include "probe.glsl"
#endif

void main() {
    float facing = countedSide(a_plane, u_light, u_reach, u_counted);
#ifdef CULLED
    if (planeSide(a_plane, u_eye, 0.0) >= 0.0) facing = 0.0;
#endif
#ifdef PROBE
    emitProbe(facing);
#else
    emitCap(a_corner, facing, a_capA, a_capB, a_capC, u_light);
#endif
}
