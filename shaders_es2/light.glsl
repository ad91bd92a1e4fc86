// Of LIT variants of surface.frag and material.frag: where the light is seen from a fragment, how
// far it reaches, and whether shadow lets it through: by the light's shadow map (MAP, with
// MAP_DIRECTIONAL, PCF and PCSS as in shadow_map_lookup.glsl; SOFT_MAP: of a light with an extent), by a mask of lower resolution
// (COARSE_MASK), by a primitive map (PRIMITIVE_MAP, see primitive_map_lookup.glsl; with
// PRIMITIVE_MAP_POINTS how many of a light's places reach there, see primitive_map_points.glsl), by how many of
// its points are seen from there (VISIBILITY), or as the stencil says, and with SELF_SHADOWED where
// the surface faces it. DIRECTIONAL: a light of one direction; RANGED and SPOT: one that doesn't reach
// everywhere, see light_window.glsl. DERIVATIVES: the GL has some, which COARSE_MASK needs.
#ifdef DIRECTIONAL
uniform vec3 u_towardsLight; // of length 1
#else
varying vec3 v_towardsLight;
#endif
#include "light_window.glsl"

#if defined(MAP) || defined(COARSE_MASK)
uniform float u_casts; // 1: the surface is a caster, dark where it is turned away from the light
#endif
#ifdef MAP
#include "shadow_map_lookup.glsl"
#endif
#ifdef COARSE_MASK
#include "coarse_mask_lookup.glsl"
#endif
#ifdef PRIMITIVE_MAP
#include "primitive_map_lookup.glsl"
#ifdef PRIMITIVE_MAP_POINTS
#include "primitive_map_points.glsl"
#endif
// The light is on the front (1) or the back (-1) of this caster, or grazes it (2); 0: it is none.
// SIDED: some triangles of the surface face the light and others don't.
#ifdef SIDED
varying float v_lightSide;
#define LIGHT_SIDE v_lightSide
#else
uniform float u_lightSide;
#define LIGHT_SIDE u_lightSide
#endif
uniform float u_mapHand; // 1, or -1 where map space mirrors the world
varying vec3 v_mapPosition;
#ifndef PRIMITIVE_MAP_DIRECTIONAL
varying float v_mapReach;
#endif
highp vec3 mapPoint; // what is looked up

// Finds it: v_mapPosition, as far towards the light as interpolating may have put it off. Rasterisers
// reckon from the picture's corner, so that the rounding of a surface seen from its edge, which
// changes much from pixel to pixel, may put a point behind it. A caster whose plane the light all but
// lies in is thinner to it than rounding: its points are moved off it, to where they are seen from,
// which is the light's side wherever the map is asked (docs/method.md, C35). Comes first in main():
// derivatives need their neighbours.
void findMapPoint() {
    mapPoint = v_mapPosition;
#ifdef PRIMITIVE_MAP_POINTS
    // Which side of a triangle the light is on is another for each of its places: nothing is moved,
    // and what lies in a triangle's plane is told by how far off rounding may have put it.
    highp vec3 reach = abs(mapPoint);
    pointError = (64.0 / 16777216.0) * max(1.0, max(max(reach.x, reach.y), reach.z));
#endif
    primitiveMoved = 0.0;
#ifndef PRIMITIVE_MAP_DIRECTIONAL
    primitiveReach = min(v_mapReach, 1.0);
#endif
#ifdef DERIVATIVES
    highp vec3 along = dFdx(mapPoint), up = dFdy(mapPoint);
    highp vec3 terms = abs(along) * gl_FragCoord.x + abs(up) * gl_FragCoord.y;
    highp float error = (terms.x + terms.y + terms.z) * (8.0 / 16777216.0);
#ifdef PRIMITIVE_MAP_POINTS
    pointError += error;
#else
    highp vec3 normal = cross(along, up) * u_mapHand; // towards the eye
    highp float size = LIGHT_SIDE == 0.0 ? 0.0 : length(normal);
    highp float aside = 16.0 / 16777216.0 / max(size, 1e-37);
#ifdef PRIMITIVE_MAP_DIRECTIONAL
    if (abs(normal.z) < 0.01 * size) mapPoint.xy += aside * normal.xy;
    mapPoint.z -= error;
    primitiveMoved = error;
#else
    highp vec3 place = abs(mapPoint);
    highp float depth = max(max(place.x, place.y), place.z);
    if (abs(dot(normal, mapPoint)) < 0.01 * depth * size) mapPoint += aside * depth * normal;
    primitiveMoved = min(error / depth, 0.5);
    mapPoint *= 1.0 - primitiveMoved;
#endif
#endif
#endif
}

// 1 or 0; with PRIMITIVE_MAP_POINTS how many places.
float litByPrimitives() {
    if (facing() * LIGHT_SIDE < 0.0 || LIGHT_SIDE > 1.5) return 0.0;
#ifdef PRIMITIVE_MAP_POINTS
    return placesSeen(mapPoint, LIGHT_SIDE > 0.0);
#else
    return primitiveMapLights(mapPoint, LIGHT_SIDE > 0.0) ? 1.0 : 0.0;
#endif
}
#endif

#ifdef VISIBILITY
uniform mediump sampler2D u_visibility; // a share in red, 255ths of its unit in green
uniform vec2 u_visibilityTexel;         // 1 / pixels

float seenOfLight() {
    vec2 share = texture2D(u_visibility, gl_FragCoord.xy * u_visibilityTexel).rg;
    return share.r + share.g / 255.0;
}
#endif

vec3 towardsLight() {
#ifdef DIRECTIONAL
    return u_towardsLight;
#else
    // Scaled before it is squared, so that far-off lights don't overflow.
    return normalize(v_towardsLight / max(max(abs(v_towardsLight.x), abs(v_towardsLight.y)),
                                          max(abs(v_towardsLight.z), 1e-30)));
#endif
}

// What shadow leaves of the light, 0..1. `lit`: what a mask of lower resolution says; `normal`
// points towards the eye; `weight`: 0 where nothing would be seen of it.
float lightThrough(float lit, vec3 normal, vec3 light, float weight) {
#ifdef MAP
    if (dot(normal, light) > 0.0)
        lit = lightFromMap(normal, light);
    else
        lit = u_casts > 0.5 ? 0.0 : lightFromMap(-normal, light);
#endif
#ifdef PRIMITIVE_MAP
#ifndef MASK
    if (weight > 0.0)
#endif
        lit = litByPrimitives();
#endif
#ifdef VISIBILITY
    lit = seenOfLight();
#endif
#ifdef SELF_SHADOWED
    if (dot(normal, light) <= 0.0) lit = 0.0;
#endif
    return lit;
}
