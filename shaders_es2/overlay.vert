// Flat coloured triangles over the picture, in its pixels, y down.
attribute vec2 a_position;
attribute vec4 a_color;

uniform vec4 u_pictureSize; // xy: in pixels

varying vec4 v_color;

void main() {
    v_color = a_color;
    vec2 share = a_position / u_pictureSize.xy;
    gl_Position = vec4(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y, 0.0, 1.0);
}
