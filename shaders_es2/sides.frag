// Sides write the stencil alone; the colour is there for the probe.
precision mediump float;
#ifdef PROBE
varying vec4 v_color;
#endif

void main() {
#ifdef PROBE
    gl_FragColor = v_color;
#else
    gl_FragColor = vec4(1.0);
#endif
}
