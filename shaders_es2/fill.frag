// Nothing in all channels; the colour mask says which are written.
precision mediump float;

void main() { gl_FragColor = vec4(0.0); }
