// The visible share of a light (sum_share.frag), in all channels; 1 where there is no surface. The
// colour mask selects the channel that is written.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
uniform highp sampler2D u_visibility; // highp, since lower precisions may round the values to fewer
                                      // bits
#else
precision mediump float;
uniform mediump sampler2D u_visibility;
#endif
uniform vec2 u_texel; // 1 / pixels

void main() {
    vec4 share = texture2D(u_visibility, gl_FragCoord.xy * u_texel);
    gl_FragColor = vec4(share.b > 0.5 ? share.r + share.g / 255.0 : 1.0);
}
