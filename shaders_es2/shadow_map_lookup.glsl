// How much of a light reaches a fragment by its shadow map: PCF x PCF texels around it compared
// with its own distance, or with PCSS what pcss.glsl makes of it. MAP_DIRECTIONAL: one flat map; MAP_APART: a cube around a point light, its
// faces in textures of their own; else a cube map.
#include "shadow_map_distance.glsl"

#ifdef MAP_DIRECTIONAL
uniform mediump sampler2D u_map; // lowp, the default, might lose the last bit of a byte
#elif defined(MAP_APART)
uniform mediump sampler2D u_face0; // +x, -x, +y, -y, +z, -z
uniform mediump sampler2D u_face1;
uniform mediump sampler2D u_face2;
uniform mediump sampler2D u_face3;
uniform mediump sampler2D u_face4;
uniform mediump sampler2D u_face5;
#else
uniform mediump samplerCube u_map;
#endif
uniform mat3 u_mapFromWorld;
uniform float u_mapStep;  // from texel to texel in the map; for a cube at distance 1
uniform float u_mapTexel; // the same as a length in the world
uniform float u_mapBias;  // in texels

varying vec3 v_mapPosition;

// What a surface that faces the light gets of the bias: interpolated normals are not those of the
// triangles that are in the map.
const float leastSlope = 0.25;
// Up to this slope receivers move towards the light, which leaves outlines where they are. Steeper
// ones move along their normal for the rest, which stays bounded.
const float steepSlope = 4.0;

float largestAxis(vec3 v) {
    vec3 a = abs(v);
    return max(a.x, max(a.y, a.z));
}

#ifndef MAP_DIRECTIONAL
vec4 texelTowards(vec3 d) {
#ifdef MAP_APART
    // As a cube map is looked up (GLES 2.0, table 3.21).
    vec3 a = abs(d);
    if (a.x >= a.y && a.x >= a.z) {
        vec2 at = vec2(d.x > 0.0 ? -d.z : d.z, -d.y) / a.x * 0.5 + 0.5;
        return d.x > 0.0 ? texture2D(u_face0, at) : texture2D(u_face1, at);
    }
    if (a.y >= a.z) {
        vec2 at = vec2(d.x, d.y > 0.0 ? d.z : -d.z) / a.y * 0.5 + 0.5;
        return d.y > 0.0 ? texture2D(u_face2, at) : texture2D(u_face3, at);
    }
    vec2 at = vec2(d.z > 0.0 ? d.x : -d.x, -d.y) / a.z * 0.5 + 0.5;
    return d.z > 0.0 ? texture2D(u_face4, at) : texture2D(u_face5, at);
#else
    return textureCube(u_map, d);
#endif
}
#endif

// Where the fragment is looked up, for a filter of `width` by `width` texels. `normal` and `light`
// have unit length and lie on the same side of the surface.
vec3 biasedReceiver(vec3 normal, vec3 light, float width) {
#ifdef MAP_DIRECTIONAL
    float texel = u_mapTexel;
#else
    float texel = u_mapTexel * largestAxis(v_mapPosition);
#endif
    // Within a texel the distance of a plane changes by the tangent of its angle to the light times
    // the texel, and a kernel reaches several. Moved along the normal by the sine, a receiver gains
    // just that tangent along the light.
    float cosine = dot(normal, light);
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float slope = min(sine / max(cosine, 0.001), steepSlope);
    float reach = u_mapBias * texel * 0.5 * (width + 1.0);
    vec3 bias = light * (leastSlope + slope) + normal * max(sine - steepSlope * cosine, 0.0);
    return v_mapPosition + u_mapFromWorld * (bias * reach);
}

#ifdef PCSS
#include "pcss.glsl"
#else
float lightFromMap(vec3 normal, vec3 light) {
    vec3 at = biasedReceiver(normal, light, float(PCF));
#ifdef MAP_DIRECTIONAL
    float own = at.z;
#else
    // The two axes of the cube's face, so that taps are whole texels apart. Past the face's edge
    // the direction simply goes on into the next face: distances are from the light itself, so they
    // compare across edges.
    vec3 a = abs(at);
    float major = largestAxis(at);
    vec3 axisS = a.x == major ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 axisT = a.x != major && a.y != major ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    axisS *= u_mapStep * major;
    axisT *= u_mapStep * major;
    float own = length(at);
#endif
    own = min(own, 1.0); // what no caster reaches, the ground for one, is as far as empty texels
    float lit = 0.0;
    for (int j = 0; j < PCF; ++j)
        for (int i = 0; i < PCF; ++i) {
            vec2 tap = vec2(float(i), float(j)) - 0.5 * float(PCF - 1);
#ifdef MAP_DIRECTIONAL
            vec4 stored = texture2D(u_map, at.xy + tap * u_mapStep);
#else
            vec4 stored = texelTowards(at + tap.x * axisS + tap.y * axisT);
#endif
            lit += own <= unpackDistance(stored) ? 1.0 : 0.0;
        }
    return lit / float(PCF * PCF);
}
#endif
