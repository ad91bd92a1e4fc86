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

// In map space, of the fragment that primitiveFind() was called for.
highp vec3 primitivePoint, primitiveAcross, primitiveTowardsEye; // across the triangle, of length 1
highp float primitiveTerms; // the largest term that was added up for the point, at least 1

void primitiveFind(highp vec3 position, highp vec3 towardsEye, highp vec3 normal) {
    highp vec3 x = u_primitiveMapFromHost[0].xyz;
    highp vec3 y = u_primitiveMapFromHost[1].xyz;
    highp vec3 z = u_primitiveMapFromHost[2].xyz;
    highp vec3 offset = u_primitiveMapFromHost[3].xyz;
    primitivePoint = x * position.x + y * position.y + z * position.z + offset;
    highp vec3 terms = abs(x * position.x) + abs(y * position.y) + abs(z * position.z) + abs(offset);
    primitiveTerms = max(max(terms.x, terms.y), max(terms.z, 1.0));
    primitiveAcross = cross(y, z) * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z;
    primitiveAcross /= max(length(primitiveAcross), 1e-36);
    primitiveTowardsEye = x * towardsEye.x + y * towardsEye.y + z * towardsEye.z;
}

// `position`: the fragment's, in the host's space; `error`: its error in units of a float's
// rounding; `towardsEye`: from there, of any length; `normal`: the triangle's, of any length and on
// either side; `casts`: all triangles there are in the map. Others are lit from behind, too.
// gl_FrontFacing has to be true where the corners run counter-clockwise in the map's meshes.
//
// The point is moved off its own triangle by as much as rounding may have put it behind: towards
// the light or, where eye and light are on different sides of the triangle and it may cast, away
// from it (docs/method.md, C35 and C36).
bool primitiveLitOn(highp vec3 position, highp vec3 towardsEye, highp vec3 normal, highp float error, bool casts) {
    primitiveFind(position, towardsEye, normal);
    highp float off = (16.0 + error) * primitiveUnit * primitiveTerms;
    highp float lightSide = PRIMITIVE_DIRECTIONAL ? -primitiveAcross.z : -dot(primitiveAcross, primitivePoint);
    bool away = lightSide * dot(primitiveAcross, primitiveTowardsEye) < 0.0;
    if (away && casts) return false;
    primitiveMoved = 0.0;
    primitiveReach = 1.0;
    off = away ? -256.0 * primitiveUnit - 2.0 * off : off;
    return primitiveMapLights(primitivePoint + primitiveAcross * (lightSide < 0.0 ? -off : off), casts && primitiveHolds && gl_FrontFacing); // so do backs
}

#ifdef PRIMITIVE_MAP_TINTS
// The share of the light that reaches the fragment, by colour.
highp vec3 primitiveLitColorOn(highp vec3 position, highp vec3 towardsEye, highp vec3 normal, highp float error, bool casts) {
    return primitiveLitOn(position, towardsEye, normal, error, casts) ? primitiveTint : vec3(0.0);
}
#endif

#ifdef PRIMITIVE_MAP_POINTS
#include "primitive_map_points.glsl"
// For the map of a light with a radius: the share of its points that reach the fragment, 0..1. The
// point isn't moved, as the light may be on both sides of its triangle (docs/method.md, C42).
highp float primitiveLitShareOn(highp vec3 position, highp vec3 towardsEye, highp vec3 normal, highp float error, bool casts) {
    primitiveFind(position, towardsEye, normal);
    pointError = (64.0 + error) * primitiveUnit * primitiveTerms;
    highp vec4 arm = primitiveTexel(u_primitivePlaces.x + 1.0); // and the number of places
    highp vec3 arms = vec3(dot(primitiveAcross, arm.xyz), dot(primitiveAcross, primitiveTexel(u_primitivePlaces.x + 2.0).xyz),
                           dot(primitiveAcross, primitiveTexel(u_primitivePlaces.x + 3.0).xyz));
    highp vec4 middle = primitiveTexel(u_primitivePlaces.x);
    placesW = middle.w;
    // Whether all of the light is clearly on one side of the triangle.
    highp vec3 towardsLight = middle.xyz - middle.w * primitivePoint;
    highp float lightSide = dot(primitiveAcross, towardsLight);
    bool whole = abs(lightSide) > length(arms) + 0.02 * length(towardsLight) + pointError;
    if (casts && whole && lightSide * dot(primitiveAcross, primitiveTowardsEye) < 0.0) return 0.0;
    bool listed = casts && whole && primitiveHolds && gl_FrontFacing; // lit sheets needn't be tested
    if (!findPrimitiveTexel(primitivePoint)) return 1.0;
    if (primitiveDepth - pointError > primitiveHeader.x) return 0.0;
    if (primitiveListIsEmpty(listed)) return 1.0;
    highp float left = 0.0;
    for (int i = 0; i < 256; ++i) {
        if (float(i) >= u_primitivePlaces.y) break;
        sixteenAt = u_primitivePlaces.x + 4.0 + 16.0 * float(i);
        left += placesLeft(primitivePoint, listed);
    }
    return left / arm.w;
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
#ifdef PRIMITIVE_MAP_POINTS
highp float primitiveLitShare(highp vec3 position, highp vec3 towardsEye, bool casts) {
    highp vec3 along = dFdx(position), up = dFdy(position);
    return primitiveLitShareOn(position, towardsEye, cross(along, up), primitiveLitError(position, along, up), casts);
}
#endif
#ifdef PRIMITIVE_MAP_TINTS
highp vec3 primitiveLitColor(highp vec3 position, highp vec3 towardsEye, bool casts) {
    return primitiveLit(position, towardsEye, casts) ? primitiveTint : vec3(0.0);
}
#endif
#endif
