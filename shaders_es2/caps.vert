// Caps of the shadow volumes: one record a triangle A < B < C, front cap then back cap (method,
// section 2; thesis, Algorithm 11).
//
// Variants: INSTANCED as in sides.vert; NEAR_DISCARD, the front cap is cut where its triangle was
// clipped by the near plane; ALPHA_TEST, texture coordinates and alpha for casters with holes, with
// u_frontCapAtInfinity saying which front cap is drawn; PROBE, for tests.
#include "record_layout.glsl"
#include "multiplicity.glsl"
#include "extrusion.glsl"

#ifdef INSTANCED
attribute vec2 a_corner; // x: vertex v of the pair of caps, 0..5
#endif
attribute vec4 a_capA; // not instanced: w = v
attribute vec4 a_capB;
attribute vec4 a_capC;
#ifdef ALPHA_TEST
attribute vec4 a_holesA; // xy: texture coordinates, z: the vertex colour's alpha
attribute vec4 a_holesB;
attribute vec4 a_holesC;
#endif

uniform vec4 u_light; // in object space
uniform mat4 u_clipFromObject;

invariant gl_Position;

#ifdef NEAR_DISCARD
varying vec2 v_clipZW;
#endif
#ifdef ALPHA_TEST
uniform float u_frontCapAtInfinity; // 1: both caps, the front one at infinity; 0: the front one
                                    // alone, where it is
varying vec3 v_holes;
varying float v_isBack;
#endif
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
    bool front = v < 2.5;
    float vertex = front ? v : 5.0 - v;
    // Facing away from the light swaps A and B.
    bool isA = vertex == (facing < 0.0 ? 1.0 : 0.0);
    bool isC = vertex == 2.0;
    vec3 p = isA ? a_capA.xyz : (isC ? a_capC.xyz : a_capB.xyz);
    vec4 corner = front ? vec4(p, 1.0) : toInfinity(p, u_light);
    vec4 clip = rasterizable(clipPosition(u_clipFromObject, corner));
#ifdef NEAR_DISCARD
    v_clipZW = clip.zw;
#endif
    bool shifted = front;
    bool drawn = facing != 0.0;
#ifdef ALPHA_TEST
    v_holes = isA ? a_holesA.xyz : (isC ? a_holesC.xyz : a_holesB.xyz);
    v_isBack = front ? 0.0 : 1.0;
    shifted = front && u_frontCapAtInfinity > 0.5;
    drawn = drawn && (front || u_frontCapAtInfinity > 0.5);
#endif
    // At infinity the front cap fails the depth test wherever its surface is visible or hidden,
    // and never fights with that surface for depth.
    gl_Position = drawn ? vec4(clip.xy, shifted ? clip.w : clip.z, clip.w) : vec4(0.0);
#endif
}
