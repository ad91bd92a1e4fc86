// Writes a caster's distance from the light. Variants: MAP_DIRECTIONAL, a flat map; MAP_PARABOLOID,
// see shadow_map.vert; with DERIVATIVES it writes the distance in the texel's own direction;
// ALPHA_TEST.
#ifdef DERIVATIVES
#extension GL_OES_standard_derivatives : enable
#endif
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
#include "shadow_map_distance.glsl"

#ifdef ALPHA_TEST
uniform sampler2D u_texture;
uniform float u_alphaScale;
uniform float u_alphaCutoff;
varying vec2 v_texcoord;
varying float v_alphaLookup;
#endif

varying vec3 v_mapPosition;

#ifdef MAP_PARABOLOID
uniform float u_halfSide;
uniform vec2 u_onDisc; // xy: scale and zw: offset from a pixel to its place on a half's disc

// Positions interpolated between vertices are in the triangle's plane, but not on the texel's ray:
// what is stored is where that ray meets the plane.
float distanceAlongRay() {
    float distance = length(v_mapPosition);
#ifdef DERIVATIVES
    vec2 onDisc = gl_FragCoord.xy * u_onDisc.x + u_onDisc.y;
    float square = dot(onDisc, onDisc);
    vec3 ray = vec3(2.0 * onDisc.x, u_halfSide * (1.0 - square), 2.0 * onDisc.y) / (1.0 + square);
    vec3 normal = cross(dFdx(v_mapPosition), dFdy(v_mapPosition));
    float across = dot(normal, ray);
    float met = dot(normal, v_mapPosition) / (abs(across) < 1e-30 ? 1e-30 : across);
    // A plane seen from its edge, where rounding decides, keeps the interpolated distance.
    if (met > 0.1 * distance && met < 10.0 * distance) distance = met;
#endif
    return distance;
}
#endif

void main() {
#ifdef ALPHA_TEST
    if (texture2D(u_texture, v_texcoord).a * u_alphaScale * v_alphaLookup < u_alphaCutoff) discard;
#endif
#ifdef MAP_DIRECTIONAL
    gl_FragColor = packDistance(v_mapPosition.z);
#elif defined(MAP_PARABOLOID)
    gl_FragColor = packDistance(distanceAlongRay());
#else
    gl_FragColor = packDistance(length(v_mapPosition));
#endif
}
