// The share of a light that is seen (sum_share.frag), in all channels; all of it where no surface
// is. The colour mask says which channel is written.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
uniform highp sampler2D u_visibility; // else what is looked up may be rounded to fewer bits
#else
precision mediump float;
uniform mediump sampler2D u_visibility;
#endif
uniform vec2 u_texel; // 1 / pixels

void main() {
    vec4 share = texture2D(u_visibility, gl_FragCoord.xy * u_texel);
    gl_FragColor = vec4(share.b > 0.5 ? share.r + share.g / 255.0 : 1.0);
}
