// Whether a resting light reaches a fragment of a host's own shader, by its primitive map
// (docs/engine.md). All names get the host's prefix (src/engine/lookup_source.cpp). Valid as GLSL
// ES 1.00 and as 3.00.
#define PRIMITIVE_MAP_ANY_LIGHT
#define PRIMITIVE_MAP_ONE_TABLE
#ifndef PRIMITIVE_MAP_LONGEST
#define PRIMITIVE_MAP_LONGEST 3072
#endif
#include "primitive_map_lookup.glsl"
uniform highp mat4 u_primitiveMapFromHost; // from the host's space, which `position` is in

const highp float primitiveUnit = 1.0 / 16777216.0;

// Whether the map holds the casters that are drawn. Hosts set it to false for those that move over
// it: their own surfaces test lit sheets, too (docs/method.md, C34).
bool primitiveHolds = true;

// `position`: the fragment's, in the host's space; `error`: its error in units of a float's
// rounding; `towardsEye`: from there, of any length; `normal`: the triangle's, of any length and on
// either side; `casts`: all triangles there are in the map. Others are lit from behind, too.
// gl_FrontFacing has to be true where the corners run counter-clockwise in the map's meshes.
//
// The point is moved off its own triangle by as much as rounding may have put it behind: towards
// the light or, where eye and light are on different sides of the triangle and it may cast, away
// from it (docs/method.md, C35 and C36).
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
    return primitiveMapLights(point, casts && primitiveHolds && gl_FrontFacing); // so do backs
}

#ifdef PRIMITIVE_MAP_TINTS
// The share of the light that reaches the fragment, by colour.
highp vec3 primitiveLitColorOn(highp vec3 position, highp vec3 towardsEye, highp vec3 normal, highp float error, bool casts) {
    return primitiveLitOn(position, towardsEye, normal, error, casts) ? primitiveTint : vec3(0.0);
}
#endif

// Error of an interpolated position, estimated from its change between pixels: rasterisers may
// compute it starting at the picture's corner.
highp float primitiveLitError(highp vec3 position, highp vec3 along, highp vec3 up) {
    highp vec3 change = abs(along) * gl_FragCoord.x + abs(up) * gl_FragCoord.y;
    highp vec3 place = abs(position);
    return 8.0 * (change.x + change.y + change.z) / max(max(place.x, place.y), max(place.z, 1e-36));
}

#if __VERSION__ >= 300 || defined(EDGESHADE_DERIVATIVES)
// The same, with derivatives: for uniform control flow, where the neighbouring fragments call it
// too.
bool primitiveLit(highp vec3 position, highp vec3 towardsEye, bool casts) {
    highp vec3 along = dFdx(position), up = dFdy(position);
    return primitiveLitOn(position, towardsEye, cross(along, up), primitiveLitError(position, along, up), casts);
}
#ifdef PRIMITIVE_MAP_TINTS
highp vec3 primitiveLitColor(highp vec3 position, highp vec3 towardsEye, bool casts) {
    return primitiveLit(position, towardsEye, casts) ? primitiveTint : vec3(0.0);
}
#endif
#endif
