// How much light reaches a place, by a filtered map (filtered_distance.glsl). The shader
// interpolates between four texels, since the GL can't filter values packed into bytes.
#include "rivals/maps/filtered_distance.glsl"
#ifdef MSM
#include "rivals/maps/moment_shadow.glsl"
#endif

uniform float u_mapTexels; // along a map's edge
// Light up to this share is taken to bleed past other casters, and is removed.
uniform float u_bleeding;

#ifdef VSM
const float leastDeviation = 2.0 / 65536.0; // the deviation that rounding causes
#endif

float withoutBleeding(float lit) { return clamp((lit - u_bleeding) / (1.0 - u_bleeding), 0.0, 1.0); }

float filteredLight(vec3 at, float own) {
    vec3 face = faceAt(at);
    vec2 texels = face.xy * u_mapTexels - 0.5;
    vec2 share = fract(texels);
    vec2 first = (floor(texels) + 0.5) / u_mapTexels;
#ifdef MSM
    MomentSum moments = MomentSum(0.0, vec4(0.0));
#else
    float mean = 0.0, square = 0.0, lit = 0.0;
#endif
    for (int i = 0; i < 4; ++i) {
        vec2 corner = vec2(mod(float(i), 2.0), floor(float(i) * 0.5));
        vec2 weights = mix(1.0 - share, share, corner);
        float weight = weights.x * weights.y;
        vec2 middle = first + corner / u_mapTexels;
#ifdef MSM
        middle.x = 0.5 * clamp(middle.x, 0.0, 1.0 - 0.5 / u_mapTexels); // the left half
        Moments there = unpackMoments(faceTexel(face.z, middle), faceTexel(face.z, middle + vec2(0.5, 0.0)));
        if (i == 0) moments.from = there.mean;
        addMoments(moments, there, weight);
#else
        vec4 texel = faceTexel(face.z, middle);
#endif
#ifdef VSM
        // Relative to the receiver, so that squares keep their digits.
        float away = unpackHalf(texel.rg) - own, deviation = unpackHalf(texel.ba);
        mean += weight * away;
        square += weight * (away * away + deviation * deviation);
#endif
#ifdef ESM
        lit += weight * exp(min(sharpness * (unpackDistance(texel) - own), 80.0));
#endif
    }
#if defined(MSM)
    return withoutBleeding(1.0 - shadowByMoments(momentsOf(moments), own));
#elif defined(VSM)
    if (mean >= 0.0) return 1.0;
    float variance = max(square - mean * mean, leastDeviation * leastDeviation);
    return withoutBleeding(variance / (variance + mean * mean)); // Chebyshev's inequality
#else
    return min(lit, 1.0);
#endif
}
