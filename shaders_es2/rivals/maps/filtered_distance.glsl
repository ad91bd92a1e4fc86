// What texels of filtered maps hold in bytes. VSM: the mean distance of what is around and its standard
// deviation, 16 bits each. That is what two moments say (Donnelly and Lauritzen 2006), but of the
// second moment itself bytes would keep no more than a deviation of 1/256. MSM: what four say, by two
// texels, see moments.glsl. ESM: a distance whose exponential is the mean of exponentials (Annen et al.
// 2008), all 32 bits of it.
#ifdef ESM
// The exponent of a distance of 1, the largest whose exponential floats hold.
const float sharpness = 80.0;
#else
vec2 packHalf(float value) {
    float whole = floor(clamp(value, 0.0, 1.0) * 65535.0 + 0.5);
    float high = floor(whole / 256.0);
    return vec2(high, whole - 256.0 * high) / 255.0;
}

float unpackHalf(vec2 bytes) {
    return dot(floor(bytes * 255.0 + 0.5), vec2(256.0, 1.0)) / 65535.0;
}
#endif
#ifdef MSM
#include "rivals/maps/moments.glsl"
#endif
