// One direction of a separable filter over PCF texels of a shadow map, with the largest weight in
// the middle. VSM, ESM or MSM: the format written, see filtered_distance.glsl; DISTANCES: for VSM
// and MSM, the texels read are still distances.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
#include "shadow_map_distance.glsl"
#include "rivals/maps/filtered_distance.glsl"

uniform mediump sampler2D u_from;
uniform vec2 u_texel;  // 1 / texels
uniform vec2 u_along;  // from texel to texel
#ifdef MSM
uniform float u_half; // selects which of the two texels is written

// Reads from a texture two maps wide.
Moments read(vec2 at) {
    vec2 left = clamp(at, 0.5 * u_texel, 1.0 - 0.5 * u_texel) * vec2(0.5, 1.0);
#ifdef DISTANCES
    return Moments(unpackDistance(texture2D(u_from, left)), 0.0, 0.0, 0.0);
#else
    return unpackMoments(texture2D(u_from, left), texture2D(u_from, left + vec2(0.5, 0.0)));
#endif
}
#elif defined(VSM)
// Returns mean and standard deviation.
vec2 read(vec2 at) {
    vec4 texel = texture2D(u_from, at);
#ifdef DISTANCES
    return vec2(unpackDistance(texel), 0.0);
#else
    return vec2(unpackHalf(texel.rg), unpackHalf(texel.ba));
#endif
}
#else
float read(vec2 at) { return unpackDistance(texture2D(u_from, at)); }
#endif

const float reach = 0.5 * float(PCF - 1);

// Weight of a texel at this offset; the weights add up to 1.
float weightOf(float aside) { return (1.0 - abs(aside) / (reach + 1.0)) / (reach + 1.0); }

void main() {
    vec2 middle = gl_FragCoord.xy * u_texel;
#if defined(MSM)
    middle.x -= u_half;
    MomentSum sum = MomentSum(read(middle).mean, vec4(0.0));
#elif defined(VSM)
    // Relative to the middle texel, so that squares keep their digits.
    float from = read(middle).x, mean = 0.0, square = 0.0;
#else
    float from = read(middle), sum = 0.0;
#endif
    for (int i = 0; i < PCF; ++i) {
        float aside = float(i) - reach;
        float weight = weightOf(aside);
#if defined(MSM)
        addMoments(sum, read(middle + aside * u_along), weight);
#elif defined(VSM)
        vec2 there = read(middle + aside * u_along);
        float away = there.x - from;
        mean += weight * away;
        square += weight * (away * away + there.y * there.y);
#else
        sum += weight * exp(sharpness * (read(middle + aside * u_along) - from));
#endif
    }
#if defined(MSM)
    gl_FragColor = packMoments(momentsOf(sum), u_half);
#elif defined(VSM)
    float deviation = sqrt(max(square - mean * mean, 0.0));
    gl_FragColor = vec4(packHalf(from + mean), packHalf(deviation));
#else
    gl_FragColor = packDistance(from + log(sum) / sharpness);
#endif
}
