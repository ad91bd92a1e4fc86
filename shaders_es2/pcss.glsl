// Percentage-closer soft shadows (Fernando 2005): how much of a light with an extent reaches a
// fragment, by the shadow map of its centre. First it searches for the mean distance of the casters
// in the map between the receiver and any part of the light, then it filters over the penumbra of a
// caster at that distance. PCSS: the light's shape (LightExtent), 0 a sphere or 1 a rectangle around
// a point light, or 2 a disc around a directional one. Needs the declarations of
// shadow_map_lookup.glsl.
const int searchTaps = 16;
const int filterTaps = 32;
// The search ignores casters nearer to a point light than this share of the receiver's distance: it
// would be so wide that it finds everything else.
const float nearestShare = 0.25;

#if PCSS == 1
uniform vec3 u_lightAcross; // half the rectangle, in map space
uniform vec3 u_lightUp;
uniform vec3 u_lightFacing;
#else
uniform float u_lightRadius; // a sphere's, in map space; for a disc the tangent of its angle
#endif
uniform float u_leastSpread; // the width of a texel; for a cube at distance 1
#ifndef MAP_DIRECTIONAL
uniform float u_nearestCaster; // in map space
#endif

// Position of the n-th of `count` taps on a disc of radius 1, evenly spread (Vogel 1979).
vec2 tapOnDisc(float n, float count) {
    float angle = 2.3999632297 * n;
    return sqrt((n + 0.5) / count) * vec2(cos(angle), sin(angle));
}

// A tap of the filter, on the light; for a rectangle Roberts' sequence in a square from -1 to 1.
vec2 filterTap(float n) {
#if PCSS == 1
    return fract((n + 0.5) * vec2(0.7548776662, 0.5698402910)) * 2.0 - 1.0;
#else
    return tapOnDisc(n, float(filterTaps));
#endif
}

// A tap of the search: on a rectangle as far from its middle, as a share of the extent, as on the
// disc.
vec2 searchTap(float n) {
    vec2 tap = tapOnDisc(n, float(searchTaps));
#if PCSS == 1
    tap *= length(tap) / max(abs(tap.x), abs(tap.y));
#endif
    return tap;
}

// Distance from the light's middle, as a share of the light's extent.
float shareOfExtent(vec2 onLight) {
#if PCSS == 1
    return max(abs(onLight.x), abs(onLight.y));
#else
    return length(onLight);
#endif
}

// The light's axes in the map around a receiver, per unit of spread.
struct Spread {
    vec3 across, up;
    float least; // the width of a texel
};

Spread spreadAt(vec3 at) {
    Spread s;
    s.least = u_leastSpread * texelScale(at);
#ifdef MAP_DIRECTIONAL
    s.across = vec3(u_lightRadius * u_mapScale.x, 0.0, 0.0);
    s.up = vec3(0.0, u_lightRadius * u_mapScale.y, 0.0);
#elif PCSS == 1
    s.across = u_lightAcross;
    s.up = u_lightUp;
#else
    vec3 along = normalize(at);
    vec3 aside = abs(along.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    s.across = u_lightRadius * normalize(cross(along, aside));
    s.up = cross(along, s.across);
#endif
    return s;
}

// How widely the shadow of a caster at that distance spreads over the map: for directional lights a
// length in the world, for others a share of the light's size.
float spreadOf(float caster, float own) {
#ifdef MAP_DIRECTIONAL
    return (own - caster) / abs(u_mapScale.z);
#else
    return own / caster - 1.0;
#endif
}

vec3 tapAt(Receiver r, Spread s, vec2 onLight, float spread) {
    return r.at + spread * (onLight.x * s.across + onLight.y * s.up);
}

// `normal` and `light` as in shadow_map_lookup.glsl.
float lightFromMap(vec3 normal, vec3 light) {
    Receiver r = receiverAt(biasedReceiver(normal, light, 1.0), normal);
    Spread s = spreadAt(r.at);
#if PCSS == 1
    if (dot(u_lightFacing, r.at) <= 0.0) return 0.0; // behind the light
#endif
#ifdef MAP_DIRECTIONAL
    float widest = spreadOf(0.0, r.own);
#else
    float widest = spreadOf(max(u_nearestCaster, nearestShare * r.own), r.own);
#endif
    widest = max(widest, s.least);
    float before = 0.0, casters = 0.0;
    for (int i = 0; i < searchTaps; ++i) {
        // Densest where the light's middle is seen, to find casters near the receiver.
        vec2 onLight = searchTap(float(i));
        float away = shareOfExtent(onLight);
        float reach = widest * away * away * away;
        vec3 tap = tapAt(r, s, onLight, reach);
        float stored = unpackDistance(texelAt(tap));
        float gap = planeDistance(r, tap) - stored;
        // A place outside all rays to the light is no caster.
        bool isBetween = reach * away <= max(spreadOf(stored, stored + gap), s.least);
        if (gap > 0.0 && isBetween) {
            before += gap;
            casters += 1.0;
        }
    }
    if (casters == 0.0) return 1.0;
    float caster = max(r.own - before / casters, 1e-6);
    float spread = clamp(spreadOf(caster, r.own), s.least, widest);
    float lit = 0.0;
    for (int i = 0; i < filterTaps; ++i) {
        vec3 tap = tapAt(r, s, filterTap(float(i)), spread);
        lit += planeDistance(r, tap) <= unpackDistance(texelAt(tap)) ? 1.0 : 0.0;
    }
    return lit / float(filterTaps);
}
