// Writes one value in all channels, 0 unless VALUE is defined; the colour mask selects the ones that
// are written.
precision mediump float;

#ifdef VALUE
uniform float u_value;
#else
const float u_value = 0.0;
#endif

void main() { gl_FragColor = vec4(u_value); }
