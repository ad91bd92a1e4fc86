// A 16-bit sum (add_bytes.frag) as a share of the largest possible sum. Red holds the first
// channel's share, green its 255ths of a 255th, and blue 1 if alpha's sum isn't 0; or, with
// PICTURE, each channel's share as a colour.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform mediump sampler2D u_low;
uniform mediump sampler2D u_high;
uniform vec2 u_texel; // 1 / pixels
uniform float u_scale; // makes a byte a share of the largest sum: 255 / that sum

void main() {
    vec2 place = gl_FragCoord.xy * u_texel;
    vec4 share = (texture2D(u_low, place) + 256.0 * texture2D(u_high, place)) * u_scale;
#ifdef PICTURE
    gl_FragColor = vec4(share.rgb, 1.0);
#else
    float units = min(share.r, 1.0) * 255.0;
    float whole = floor(units + 1.0 / 512.0);
    gl_FragColor = vec4(whole / 255.0, max(units - whole, 0.0), share.a > 0.0 ? 1.0 : 0.0, 1.0);
#endif
}
