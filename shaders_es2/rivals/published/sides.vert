// Sides of the shadow volumes: one record per edge (docs/method.md, Records and caps, as published;
// thesis, Algorithm 10).
//
// Variants: MAX_MULTIPLICITY 1..5, opposite vertices per record; INSTANCED, one record per
// instance, with the corner in its own attribute, else in spare components; SIDE_IS_UNIFORM (with
// INSTANCED), one draw per side; PROBE, for tests: the record's multiplicity as a coloured point
// instead of its sides; DEGENERATE, for measuring: everything is computed, and every vertex ends up
// at (0,0,0,0).
#include "record_layout.glsl"
#include "rivals/published/multiplicity.glsl"
#include "extrusion.glsl"

#ifdef INSTANCED
attribute vec2 a_corner; // x: vertex v of the side, 0..5; y: index s of the side
#endif
attribute vec4 a_edgeA; // when not instanced: w = v
attribute vec4 a_edgeB; // when not instanced: w = s
attribute vec4 a_opposite0;
#if MAX_MULTIPLICITY > 1
attribute vec4 a_opposite1;
#endif
#if MAX_MULTIPLICITY > 2
attribute vec4 a_opposite2;
#endif
#if MAX_MULTIPLICITY > 3
attribute vec4 a_opposite3;
#endif
#if MAX_MULTIPLICITY > 4
attribute vec4 a_opposite4;
#endif

uniform vec4 u_light;            // in object space
uniform mat4 u_clipFromObject;
#ifdef SIDE_IS_UNIFORM
uniform float u_side;
#endif
#ifdef DEGENERATE
uniform float u_degenerate; // never set, so 0, which no compiler knows
#endif

invariant gl_Position;

float edgeMultiplicity() {
    float m = oppositeMultiplicity(a_edgeA.xyz, a_edgeB.xyz, a_opposite0, u_light);
#if MAX_MULTIPLICITY > 1
    m += oppositeMultiplicity(a_edgeA.xyz, a_edgeB.xyz, a_opposite1, u_light);
#endif
#if MAX_MULTIPLICITY > 2
    m += oppositeMultiplicity(a_edgeA.xyz, a_edgeB.xyz, a_opposite2, u_light);
#endif
#if MAX_MULTIPLICITY > 3
    m += oppositeMultiplicity(a_edgeA.xyz, a_edgeB.xyz, a_opposite3, u_light);
#endif
#if MAX_MULTIPLICITY > 4
    m += oppositeMultiplicity(a_edgeA.xyz, a_edgeB.xyz, a_opposite4, u_light);
#endif
    return m;
}

#ifdef PROBE
#include "probe.glsl"
#endif

void main() {
    float multiplicity = edgeMultiplicity();
#ifdef PROBE
    emitProbe(multiplicity);
#else
#ifdef INSTANCED
    float v = a_corner.x;
#ifdef SIDE_IS_UNIFORM
    float side = u_side;
#else
    float side = a_corner.y;
#endif
#else
    float v = a_edgeA.w;
    float side = a_edgeB.w;
#endif
    // Thesis, Equations 6.3 to 6.5. Both windings share one diagonal, P1 to P2.
    float id = multiplicity > 0.0 ? (v > 2.5 ? v - 2.0 : 2.0 - v) : (v > 2.5 ? 6.0 - v : v);
    vec3 end = id == 0.0 || id == 2.0 ? a_edgeA.xyz : a_edgeB.xyz;
    vec4 corner = id > 1.5 ? toInfinity(end, u_light) : vec4(end, 1.0);
    // An unused vertex makes its triangle a point, which covers no pixel.
    gl_Position = side < abs(multiplicity) ? rasterizable(u_clipFromObject, clipPosition(u_clipFromObject, corner))
                                           : vec4(0.0);
#ifdef DEGENERATE
    gl_Position *= u_degenerate;
#endif
#endif
}
