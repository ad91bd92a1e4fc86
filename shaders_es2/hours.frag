// Hours of sunlight as colours: each pixel's sum of lit masks (add_bytes.frag), as a share of the
// largest sum, is looked up in a row of 256 colours. Pixels without a surface get the background.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform mediump sampler2D u_low;
uniform mediump sampler2D u_high;
uniform mediump sampler2D u_colors;
uniform vec2 u_texel; // 1 / pixels
uniform float u_scale; // makes a byte a share of the largest sum: 255 / that sum
uniform vec3 u_background;

void main() {
    vec2 place = gl_FragCoord.xy * u_texel;
    vec4 sum = texture2D(u_low, place) + 256.0 * texture2D(u_high, place);
    float share = min(sum.r * u_scale, 1.0);
    vec3 color = texture2D(u_colors, vec2((255.0 * share + 0.5) / 256.0, 0.5)).rgb;
    gl_FragColor = vec4(sum.a > 0.0 ? color : u_background, 1.0);
}
