// The part of a caster that is between the light and the plane that it is projected onto. Writes
// only the stencil. CLIPPED: some of the caster isn't there; ALPHA_TEST: alpha-tested materials;
// TINT and UNIFORM_TINT as in sides.frag.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

#ifdef UNIFORM_TINT
uniform vec4 u_tint;
#endif
#ifdef CLIPPED
uniform vec2 u_heights; // above the plane, below the light
varying float v_height;
#endif
#ifdef ALPHA_TEST
uniform sampler2D u_texture;
uniform float u_alphaScale;
uniform float u_alphaCutoff;
varying vec2 v_texcoord;
varying float v_alphaLookup;
#endif

void main() {
#ifdef CLIPPED
    if (v_height <= u_heights.x || v_height >= u_heights.y) discard;
#endif
#ifdef ALPHA_TEST
    if (u_alphaScale * v_alphaLookup * texture2D(u_texture, v_texcoord).a < u_alphaCutoff) discard;
#endif
#ifdef TINT
    gl_FragColor = TINT;
#else
    gl_FragColor = vec4(1.0);
#endif
}
