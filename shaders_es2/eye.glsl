// The eye's position as a fragment sees it.
uniform vec4 u_eye;     // relative to v_fromEye's origin, homogeneous
varying vec3 v_fromEye; // world axes

// From the fragment to the eye, not normalised.
vec3 towardsEye() { return u_eye.xyz - v_fromEye * u_eye.w; }
