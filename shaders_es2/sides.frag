// Sides write only the stencil. The colour is for the probe and for TINT, the colours of debug
// views: a vec4, or u_tint with UNIFORM_TINT.
precision mediump float;
#ifdef UNIFORM_TINT
uniform vec4 u_tint;
#endif
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
