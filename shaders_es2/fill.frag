// Writes 0 in all channels; the colour mask selects the ones that are written.
precision mediump float;

void main() { gl_FragColor = vec4(0.0); }
