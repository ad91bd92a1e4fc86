// How the texels of filtered maps encode distances in bytes. VSM: the mean distance around a texel
// and its standard deviation, 16 bits each. This is the information of two moments (Donnelly and
// Lauritzen 2006), but the second moment itself, in bytes, would resolve a deviation no finer than
// 1/256. MSM: four moments in two texels, see moments.glsl. ESM: a distance whose exponential is
// the mean of exponentials (Annen et al. 2008), in all 32 bits.
#ifdef ESM
// The exponent for a distance of 1: the largest whose exponential a float holds.
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
