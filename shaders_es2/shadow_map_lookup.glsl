// How much of a light reaches a fragment, by its shadow map (shadow_map_faces.glsl lists the
// kinds). Compares PCF x PCF texels around the fragment with its own distance. POISSON: taps in a
// disc that wide; VSM, ESM and MSM: the value of a filtered map; PCSS: the result of pcss.glsl.
#include "shadow_map_distance.glsl"
uniform float u_mapTexel; // u_mapStep as a length in the world
#include "shadow_map_faces.glsl"

uniform mat3 u_mapFromWorld;
uniform float u_mapBias;  // in texels

varying vec3 v_mapPosition;

// Least bias, for a surface that faces the light: interpolated normals differ from those of the
// triangles in the map.
const float leastSlope = 0.25;
// Up to this slope receivers move towards the light, which keeps outlines in place. Steeper ones
// move along their normal for the rest, which stays bounded.
const float steepSlope = 4.0;

// The place where the fragment is looked up, for a filter of `width` by `width` texels. `normal`
// and `light` have unit length and lie on the same side of the surface.
vec3 biasedReceiver(vec3 normal, vec3 light, float width) {
#ifdef MAP_WARPED
    useWarp(v_mapPosition.xy);
#endif
    float texel = u_mapTexel * texelScale(v_mapPosition);
    // Within a texel the distance of a plane changes by the tangent of its angle to the light times
    // the texel, and a kernel reaches several. Moved along the normal by the sine, a receiver gains
    // exactly that tangent along the light.
    float cosine = dot(normal, light);
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float slope = min(sine / max(cosine, 0.001), steepSlope);
    float reach = u_mapBias * texel * 0.5 * (width + 1.0);
    vec3 bias = light * (leastSlope + slope) + normal * max(sine - steepSlope * cosine, 0.0);
    vec3 at = v_mapPosition + u_mapFromWorld * (bias * reach);
#ifdef MAP_WARPED
    useWarp(at.xy);
#endif
    return at;
}

#if defined(PCSS) || defined(POISSON)
#include "receiver_plane.glsl"
#endif
#ifdef POISSON
#include "rivals/maps/poisson.glsl"
#endif
#if defined(VSM) || defined(ESM) || defined(MSM)
#define FILTERED
#include "rivals/maps/filtered_map.glsl"
#endif

#ifdef PCSS
#include "pcss.glsl"
#else
float lightByFace(vec3 normal, vec3 light) {
#ifdef POISSON
    vec3 at = biasedReceiver(normal, light, 1.0), axisS, axisT;
    texelAxes(at, axisS, axisT);
    return poissonLit(receiverAt(at, normal), axisS, axisT);
#else
    vec3 at = biasedReceiver(normal, light, float(PCF));
    float own = min(distanceOf(at), 1.0); // a receiver that no caster reaches, such as the ground,
                                          // is as far as empty texels
#ifdef FILTERED
    return filteredLight(at, own);
#else
    vec3 axisS, axisT;
    texelAxes(at, axisS, axisT);
    float lit = 0.0;
    for (int j = 0; j < PCF; ++j)
        for (int i = 0; i < PCF; ++i) {
            vec2 tap = vec2(float(i), float(j)) - 0.5 * float(PCF - 1);
            lit += own <= unpackDistance(texelAt(at + tap.x * axisS + tap.y * axisT)) ? 1.0 : 0.0;
        }
    return lit / float(PCF * PCF);
#endif
#endif
}

float lightFromMap(vec3 normal, vec3 light) {
#ifdef MAP_CASCADES
    float next;
    int cascade = cascadeOf(v_mapPosition.xy, next);
    useCascade(cascade);
    float lit = lightByFace(normal, light);
    if (next > 0.0) {
        useCascade(cascade + 1);
        lit = mix(lit, lightByFace(normal, light), next);
    }
    return lit;
#else
    return lightByFace(normal, light);
#endif
}
#endif
