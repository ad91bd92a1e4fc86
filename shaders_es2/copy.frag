// A texture's texels, one for each pixel.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform sampler2D u_picture;
uniform vec4 u_texelFromPixel; // scale and offset

void main() {
    gl_FragColor = texture2D(u_picture, gl_FragCoord.xy * u_texelFromPixel.xy + u_texelFromPixel.zw);
}
