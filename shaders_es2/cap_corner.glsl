// Emits one corner of a pair of caps; shared by caps.vert and plane_pair_caps.vert.
//
// Variants: NEAR_DISCARD, the front cap is cut where its triangle was clipped by the near plane;
// ALPHA_TEST, texture coordinates and alpha for alpha-tested casters, with u_frontCapAtInfinity
// saying which front cap is drawn; CULLED, front caps stay where they are.
#include "extrusion.glsl"

invariant gl_Position;

#ifdef ALPHA_TEST
attribute vec4 a_alphaCornerA; // xy: texture coordinates, z: the vertex colour's alpha
attribute vec4 a_alphaCornerB;
attribute vec4 a_alphaCornerC;
#endif

uniform mat4 u_clipFromObject;

#ifdef NEAR_DISCARD
varying vec2 v_clipZW;
#endif
#ifdef ALPHA_TEST
uniform mat3 u_texcoordTransform;
uniform float u_frontCapAtInfinity; // 1: draw both caps, the front one at infinity; 0: only the
                                    // front cap, in place
varying vec3 v_alphaLookup;
varying float v_isBack;
#endif

// v: 0..2 for the front cap, 3..5 for the back cap of a triangle a, b, c that the light sees
// counter-clockwise (facing > 0), clockwise (facing < 0) or not at all (0).
void emitCap(float v, float facing, vec3 a, vec3 b, vec3 c, vec4 light) {
    bool front = v < 2.5;
    float vertex = front ? v : 5.0 - v;
    // Facing away from the light swaps A and B.
    bool isA = vertex == (facing < 0.0 ? 1.0 : 0.0);
    bool isC = vertex == 2.0;
    vec3 p = isA ? a : (isC ? c : b);
    vec4 corner = front ? vec4(p, 1.0) : toInfinity(p, light);
    vec4 clip = rasterizable(u_clipFromObject, clipPosition(u_clipFromObject, corner));
#ifdef NEAR_DISCARD
    v_clipZW = clip.zw;
#endif
    bool shifted = front;
    bool drawn = facing != 0.0;
#ifdef ALPHA_TEST
    vec3 lookup = isA ? a_alphaCornerA.xyz : (isC ? a_alphaCornerC.xyz : a_alphaCornerB.xyz);
    v_alphaLookup = vec3((u_texcoordTransform * vec3(lookup.xy, 1.0)).xy, lookup.z);
    v_isBack = front ? 0.0 : 1.0;
    shifted = front && u_frontCapAtInfinity > 0.5;
    drawn = drawn && (front || u_frontCapAtInfinity > 0.5);
#endif
#ifdef CULLED
    shifted = false;
#endif
    gl_Position = drawn ? (shifted ? movedToInfinity(clip) : clip) : vec4(0.0);
}
