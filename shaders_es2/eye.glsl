// Where a fragment is seen from.
uniform vec4 u_eye;     // as seen from v_fromEye's origin, homogeneous
varying vec3 v_fromEye; // world axes

// Of any length.
vec3 towardsEye() { return u_eye.xyz - v_fromEye * u_eye.w; }
