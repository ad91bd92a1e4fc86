// The nearness of a fragment: 1 at the near plane. Perspective: the inverse of the depth in units
// of the near plane's distance; ORTHOGRAPHIC: the distance left to the far plane, as a share of the
// depth range. Along a plane it changes linearly over the picture.
#ifdef ORTHOGRAPHIC
varying vec3 v_clip; // w is 1
#else
uniform float u_near; // scene units

varying vec3 v_clip; // x, y and w
#endif

float nearnessHere() {
#ifdef ORTHOGRAPHIC
    return 0.5 - 0.5 * v_clip.z;
#else
    return u_near / v_clip.z;
#endif
}

const float largestInverse = 16777215.0; // the largest number of three bytes

// Three bytes as 255ths, the highest first.
vec3 nearnessBytes(float nearness) {
    float rest = floor(clamp(nearness, 0.0, 1.0) * largestInverse + 0.5);
    vec3 bytes;
    bytes.r = floor(rest / 65536.0);
    rest -= bytes.r * 65536.0;
    bytes.g = floor(rest / 256.0);
    bytes.b = rest - bytes.g * 256.0;
    return bytes;
}
