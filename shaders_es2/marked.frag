// Keeps the pixels that a texture, one texel a pixel, marks with alpha, and discards the others.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform sampler2D u_marked;
uniform vec4 u_texelFromPixel; // scale and offset

void main() {
    vec2 texel = gl_FragCoord.xy * u_texelFromPixel.xy + u_texelFromPixel.zw;
    if (texture2D(u_marked, texel).a < 0.5) discard;
    gl_FragColor = vec4(0.0);
}
