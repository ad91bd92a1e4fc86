// Sides write the stencil alone; the colour is there for the probe, and for TINT,
// the vec4 that debug views colour them with.
precision mediump float;
#ifdef PROBE
varying vec4 v_color;
#endif

void main() {
#ifdef PROBE
    gl_FragColor = v_color;
#elif defined(TINT)
    gl_FragColor = TINT;
#else
    gl_FragColor = vec4(1.0);
#endif
}
