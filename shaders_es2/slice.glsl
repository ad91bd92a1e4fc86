// SLICED: a depth slice, which shows nothing deeper than u_farthest.
#ifdef SLICED
uniform float u_farthest;
varying float v_depth; // along the viewing direction
void discardBeyondSlice() {
    if (v_depth > u_farthest) discard;
}
#else
void discardBeyondSlice() {}
#endif
