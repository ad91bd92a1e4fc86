// Layout of a shadow map's texels. A place is in map space (see ShadowMapView). MAP_FACES: the map
// is this many flat textures: the six faces of a cube; with MAP_PARABOLOID two halves of all
// directions; with MAP_DIRECTIONAL one (MAP_WARPED, see warp.glsl) or, with MAP_CASCADES, several
// parallel projections. Without it the map is a cube map.
#ifdef MAP_FACES
uniform mediump sampler2D u_face0; // lowp, the default, might lose the last bit of a byte
#if MAP_FACES > 1
uniform mediump sampler2D u_face1;
#endif
#if MAP_FACES > 2
uniform mediump sampler2D u_face2; // for a cube +x, -x, +y, -y, +z, -z
#endif
#if MAP_FACES > 3
uniform mediump sampler2D u_face3;
#endif
#if MAP_FACES > 4
uniform mediump sampler2D u_face4;
uniform mediump sampler2D u_face5;
#endif
#else
uniform mediump samplerCube u_map;
#endif
uniform float u_mapStep; // from texel to texel in the map; for a point light at distance 1
#if defined(MAP_FACES) && !defined(MAP_DIRECTIONAL)
uniform float u_mapShare; // share of its texture's width that a face takes; the rest is a margin
#endif

#ifdef MAP_DIRECTIONAL
uniform vec3 u_mapScale; // map space per length in the world, along each axis
#endif

float largestAxis(vec3 v) {
    vec3 a = abs(v);
    return max(a.x, max(a.y, a.z));
}

#ifdef MAP_CASCADES
#include "cascades.glsl"
#endif
#ifdef MAP_WARPED
#include "rivals/maps/warp.glsl"
#endif

#ifdef MAP_FACES
vec4 faceTexel(float face, vec2 at) {
#if MAP_FACES > 4
    if (face > 4.5) return texture2D(u_face5, at);
    if (face > 3.5) return texture2D(u_face4, at);
#endif
#if MAP_FACES > 3
    if (face > 2.5) return texture2D(u_face3, at);
#endif
#if MAP_FACES > 2
    if (face > 1.5) return texture2D(u_face2, at);
#endif
#if MAP_FACES > 1
    if (face > 0.5) return texture2D(u_face1, at);
#endif
    return texture2D(u_face0, at);
}

// Coordinates in a face's texture, and the face's number.
vec3 faceAt(vec3 at) {
#if defined(MAP_CASCADES)
    return vec3(at.xy * mapCascade.xy + mapCascade.zw, mapFace);
#elif defined(MAP_WARPED)
    return vec3(warped(at.xy), 0.0);
#elif defined(MAP_DIRECTIONAL)
    return vec3(at.xy, 0.0);
#elif defined(MAP_PARABOLOID)
    vec2 onDisc = at.xz / (length(at) + abs(at.y));
    return vec3(onDisc * (0.5 * u_mapShare) + 0.5, at.y < 0.0 ? 1.0 : 0.0);
#else
    // The selection that a cube map lookup makes (GLES 2.0, table 3.21).
    vec3 a = abs(at);
    float share = 0.5 * u_mapShare;
    if (a.x >= a.y && a.x >= a.z)
        return vec3(vec2(at.x > 0.0 ? -at.z : at.z, -at.y) / a.x * share + 0.5, at.x > 0.0 ? 0.0 : 1.0);
    if (a.y >= a.z)
        return vec3(vec2(at.x, at.y > 0.0 ? at.z : -at.z) / a.y * share + 0.5, at.y > 0.0 ? 2.0 : 3.0);
    return vec3(vec2(at.z > 0.0 ? at.x : -at.x, -at.y) / a.z * share + 0.5, at.z > 0.0 ? 4.0 : 5.0);
#endif
}
#endif

vec4 texelAt(vec3 at) {
#ifdef MAP_FACES
    vec3 face = faceAt(at);
    return faceTexel(face.z, face.xy);
#else
    return textureCube(u_map, at);
#endif
}

float distanceOf(vec3 at) {
#ifdef MAP_DIRECTIONAL
    return at.z;
#else
    return length(at);
#endif
}

// Width of the texels there, relative to those at 1 in the direction in which a point light's map
// is finest. A paraboloid's texels are twice as wide as its finest where its directions meet the
// other half.
float texelScale(vec3 at) {
#if defined(MAP_CASCADES)
    return 1.0 / min(mapCascade.x, mapCascade.y);
#elif defined(MAP_WARPED)
    vec3 axisS, axisT;
    warpAxes(u_mapStep, axisS, axisT);
    return max(length(axisS.xy / u_mapScale.xy), length(axisT.xy / u_mapScale.xy)) / u_mapTexel;
#elif defined(MAP_DIRECTIONAL)
    return 1.0;
#elif defined(MAP_PARABOLOID)
    return length(at) + abs(at.y);
#else
    return largestAxis(at);
#endif
}

// From a texel to its neighbours, in map space.
void texelAxes(vec3 at, out vec3 axisS, out vec3 axisT) {
#if defined(MAP_CASCADES)
    axisS = vec3(u_mapStep / mapCascade.x, 0.0, 0.0);
    axisT = vec3(0.0, u_mapStep / mapCascade.y, 0.0);
#elif defined(MAP_WARPED)
    warpAxes(u_mapStep, axisS, axisT);
#elif defined(MAP_DIRECTIONAL)
    axisS = vec3(u_mapStep, 0.0, 0.0);
    axisT = vec3(0.0, u_mapStep, 0.0);
#elif defined(MAP_PARABOLOID)
    // A paraboloid keeps angles: any two axes across the direction will do.
    vec3 along = normalize(at);
    axisS = normalize(cross(along, abs(along.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    axisT = cross(along, axisS) * (u_mapStep * texelScale(at));
    axisS *= u_mapStep * texelScale(at);
#else
    // The two axes of the cube's face, so that taps are whole texels apart. Past the face's edge
    // the direction simply continues in the next face: distances are from the light itself, so they
    // compare across edges.
    vec3 a = abs(at);
    float major = largestAxis(at);
    axisS = a.x == major ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    axisT = a.x != major && a.y != major ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
    axisS *= u_mapStep * major;
    axisT *= u_mapStep * major;
#endif
}
