// Maps linear light to display colours and back: Khronos PBR Neutral, then the sRGB curve (IEC
// 61966-2-1). Neutral keeps colours below `shown`, less the 0.04 of everything around that a
// dielectric reflects; brighter ones approach 1 and lose their colour.
const float reflected = 0.04;
const float shown = 0.8 - reflected;
const float whitening = 0.15;

vec3 srgbFromLinear(vec3 light) {
    vec3 curve = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return mix(light * 12.92, curve, step(vec3(0.0031308), light));
}

vec3 linearFromSrgb(vec3 color) {
    vec3 curve = pow((max(color, vec3(0.04045)) + 0.055) / 1.055, vec3(2.4));
    return mix(color / 12.92, curve, step(vec3(0.04045), color));
}

vec3 neutral(vec3 light) {
    float least = min(light.r, min(light.g, light.b));
    light -= least < 2.0 * reflected ? least - least * least / (4.0 * reflected) : reflected;
    float most = max(light.r, max(light.g, light.b));
    if (most < shown) return light;
    float room = 1.0 - shown;
    float kept = 1.0 - room * room / (most - shown + room);
    float white = 1.0 - 1.0 / (whitening * (most - kept) + 1.0);
    return mix(light * (kept / most), vec3(kept), white);
}

vec3 displayed(vec3 light) { return srgbFromLinear(clamp(neutral(light), 0.0, 1.0)); }
