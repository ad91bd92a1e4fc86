// Surfaces as a coarse mask needs them: depth, and each texel's plane. Variants ALPHA_TEST,
// ALPHA_LOOKUP, TEXTURED, COLORED and SLICED: see surface.frag; NEARNESS_ALONE: nearness without
// the plane, which also works in a GL without derivatives.
#ifndef NEARNESS_ALONE
#extension GL_OES_standard_derivatives : enable
#endif
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
#ifdef NEARNESS_ALONE
#include "nearness.glsl"
#else
#include "coarse_plane.glsl"
#endif

#ifdef ALPHA_TEST
uniform vec4 u_baseColor;
uniform float u_alphaCutoff;
#ifdef ALPHA_LOOKUP
uniform vec4 u_alphaChannel;
#endif
#ifdef TEXTURED
uniform sampler2D u_texture;
varying vec2 v_texcoord;
#endif
#ifdef COLORED
varying vec4 v_color;
#endif
#endif
#include "slice.glsl"

void main() {
#ifndef NEARNESS_ALONE
    Plane plane = planeHere(); // before any discard: derivatives need the neighbouring fragments
#endif
    discardBeyondSlice();
#ifdef ALPHA_TEST
    float alpha = u_baseColor.a;
#ifdef COLORED
    alpha *= v_color.a;
#endif
#ifdef TEXTURED
    vec4 texel = texture2D(u_texture, v_texcoord);
#ifdef ALPHA_LOOKUP
    texel.a = dot(texel, u_alphaChannel);
#endif
    alpha *= texel.a;
#endif
    if (alpha < u_alphaCutoff) discard;
#endif
#ifdef NEARNESS_ALONE
    gl_FragColor = vec4(nearnessBytes(nearnessHere()) / 255.0, 1.0);
#else
    gl_FragColor = packPlane(plane);
#endif
}
