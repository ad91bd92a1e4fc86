// Pixels that a texture, one texel a pixel, marks with alpha; no others.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform sampler2D u_marked;
uniform vec2 u_texelFromPixel;

void main() {
    if (texture2D(u_marked, gl_FragCoord.xy * u_texelFromPixel).a < 0.5) discard;
    gl_FragColor = vec4(0.0);
}
