// Test aid: one point per record, whose colour is a number that the GL computed.
attribute vec2 a_pixel; // centre of the record's pixel, in normalised device coordinates
varying vec4 v_color;

void emitProbe(float number) {
    v_color = vec4((number + 128.0) / 255.0, 0.0, 0.0, 1.0);
    gl_Position = vec4(a_pixel, 0.0, 1.0);
    gl_PointSize = 1.0;
}
