// Adds a picture's bytes to 16-bit sums, which two pictures hold as low and high bytes. Writes the
// new low bytes or, with HIGH, the new high bytes. For alpha, the sum counts the pictures in which
// alpha isn't 0. Exact, even with 10-bit floats.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform mediump sampler2D u_added;
uniform mediump sampler2D u_low;
uniform vec2 u_texel; // 1 / pixels
#ifdef HIGH
uniform mediump sampler2D u_high;
#endif

vec4 bytes(vec4 color) { return floor(color * 255.0 + 0.5); }

void main() {
    vec2 place = gl_FragCoord.xy * u_texel;
    vec4 added = bytes(texture2D(u_added, place));
    added.a = min(added.a, 1.0);
    vec4 sum = bytes(texture2D(u_low, place)) + added;
    vec4 carry = step(256.0, sum);
#ifdef HIGH
    gl_FragColor = (bytes(texture2D(u_high, place)) + carry) / 255.0;
#else
    gl_FragColor = (sum - 256.0 * carry) / 255.0;
#endif
}
