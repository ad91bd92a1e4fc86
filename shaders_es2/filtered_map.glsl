// How much of the light reaches a place by a filtered map, see filtered_distance.glsl. Bytes are
// averaged between four texels here, since the GL can't.
#include "filtered_distance.glsl"

uniform float u_mapTexels; // a texture's width

#ifdef VSM
// Of what may be brighter than shadow this share is taken for other casters' light and left out.
const float bleeding = 0.2;
const float leastDeviation = 2.0 / 65536.0; // rounding makes that much
#endif

float filteredLight(vec3 at, float own) {
    vec3 face = faceAt(at);
    vec2 texels = face.xy * u_mapTexels - 0.5;
    vec2 share = fract(texels);
    vec2 first = (floor(texels) + 0.5) / u_mapTexels;
    float mean = 0.0, square = 0.0, lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 corner = vec2(mod(float(i), 2.0), floor(float(i) * 0.5));
        vec2 weights = mix(1.0 - share, share, corner);
        float weight = weights.x * weights.y;
        vec4 texel = faceTexel(face.z, first + corner / u_mapTexels);
#ifdef VSM
        // From the receiver, so that squares keep their digits.
        float away = unpackHalf(texel.rg) - own, deviation = unpackHalf(texel.ba);
        mean += weight * away;
        square += weight * (away * away + deviation * deviation);
#else
        lit += weight * exp(min(sharpness * (unpackDistance(texel) - own), 80.0));
#endif
    }
#ifdef VSM
    if (mean >= 0.0) return 1.0;
    float variance = max(square - mean * mean, leastDeviation * leastDeviation);
    float most = variance / (variance + mean * mean); // Chebyshev's inequality
    return clamp((most - bleeding) / (1.0 - bleeding), 0.0, 1.0);
#else
    return min(lit, 1.0);
#endif
}
