// See surface_number.vert.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

#ifdef ALPHA_TEST
uniform sampler2D u_texture;
uniform vec4 u_alphaChannel; // 1 in the channel that holds alpha
uniform float u_alphaScale;
uniform float u_alphaCutoff;
varying vec2 v_texcoord;
varying float v_alpha;
#endif
#include "slice.glsl"
varying vec3 v_number;

void main() {
    discardBeyondSlice();
#ifdef ALPHA_TEST
    if (u_alphaScale * v_alpha * dot(texture2D(u_texture, v_texcoord), u_alphaChannel) < u_alphaCutoff)
        discard;
#endif
    gl_FragColor = vec4(v_number, 1.0);
}
