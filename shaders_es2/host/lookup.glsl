// Whether a light at rest reaches a fragment of a host's own shader, by its map (docs/engine.md). All
// names get the host's prefix (src/engine/lookup_source.cpp). GLSL ES 1.00, and 3.00 as it stands.
#define PRIMITIVE_MAP_ANY_LIGHT
#define PRIMITIVE_MAP_ONE_TABLE
#ifndef PRIMITIVE_MAP_LONGEST
#define PRIMITIVE_MAP_LONGEST 3072
#endif
#include "primitive_map_lookup.glsl"
uniform highp mat4 u_primitiveMapFromHost; // from the space of `position`

const highp float primitiveUnit = 1.0 / 16777216.0;

// `position`: of the fragment, in the host's space, `error` times as far off as rounding a float;
// `towardsEye`: from there, of any length; `normal`: of the triangle, of any length and either side;
// `casts`: all triangles there are in the map. Others are lit from behind, too. What points at the
// fragment's own triangle is moved off it by what rounding may have put it behind it; towards the
// light, or where eye and light are on different sides of it, and it may cast, away from it
// (docs/method.md, C35 and C36).
bool primitiveLitOn(highp vec3 position, highp vec3 towardsEye, highp vec3 normal, highp float error, bool casts) {
    highp vec3 x = u_primitiveMapFromHost[0].xyz;
    highp vec3 y = u_primitiveMapFromHost[1].xyz;
    highp vec3 z = u_primitiveMapFromHost[2].xyz;
    highp vec3 offset = u_primitiveMapFromHost[3].xyz;
    highp vec3 point = x * position.x + y * position.y + z * position.z + offset;
    highp vec3 terms = abs(x * position.x) + abs(y * position.y) + abs(z * position.z) + abs(offset);
    highp float off = (16.0 + error) * primitiveUnit * max(max(terms.x, terms.y), max(terms.z, 1.0));
    highp vec3 across = cross(y, z) * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z;
    across /= max(length(across), 1e-36);
    highp float lightSide = PRIMITIVE_DIRECTIONAL ? -across.z : -dot(across, point);
    highp float eyeSide = dot(across, x * towardsEye.x + y * towardsEye.y + z * towardsEye.z);
    bool away = lightSide * eyeSide < 0.0;
    if (away && casts) return false;
    if (lightSide < 0.0) across = -across;
    primitiveMoved = 0.0;
    primitiveReach = 1.0;
    point += across * (away ? -256.0 * primitiveUnit - 2.0 * off : off);
    return primitiveMapLights(point, casts);
}

// How far off interpolating may put it, by how it changes from pixel to pixel: rasterisers may reckon
// from the picture's corner.
highp float primitiveLitError(highp vec3 position, highp vec3 along, highp vec3 up) {
    highp vec3 change = abs(along) * gl_FragCoord.x + abs(up) * gl_FragCoord.y;
    highp vec3 place = abs(position);
    return 8.0 * (change.x + change.y + change.z) / max(max(place.x, place.y), max(place.z, 1e-36));
}

#if __VERSION__ >= 300 || defined(EDGESHADE_DERIVATIVES)
// The same by derivatives: for where a fragment's neighbours ask, too.
bool primitiveLit(highp vec3 position, highp vec3 towardsEye, bool casts) {
    highp vec3 along = dFdx(position), up = dFdy(position);
    return primitiveLitOn(position, towardsEye, cross(along, up), primitiveLitError(position, along, up), casts);
}
#endif
