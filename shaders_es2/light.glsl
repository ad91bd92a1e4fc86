// For LIT variants of surface.frag and material.frag: the direction to the light, how far it
// reaches, and whether shadow lets it through. The shadow comes from
//   MAP              the light's shadow map, with MAP_DIRECTIONAL, PCF and PCSS as in
//                    shadow_map_lookup.glsl; SOFT_MAP: the light has an extent
//   COARSE_MASK      a mask of lower resolution
//   PRIMITIVE_MAP    a primitive map (primitive_map_lookup.glsl); with PRIMITIVE_MAP_POINTS it
//                    counts the light's points that reach the fragment (primitive_map_points.glsl)
//   VISIBILITY       a texture with the share of the light's points that are visible from there
// or else the stencil; with SELF_SHADOWED a surface is also dark where it faces away from the
// light. DIRECTIONAL: a light of one direction; RANGED and SPOT: one that doesn't reach everywhere,
// see light_window.glsl. DERIVATIVES: the GL has derivatives, which COARSE_MASK needs.
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
// The light is on the front (1) or the back (-1) of this caster, or grazes it (2); 0: the surface
// is no caster. SIDED: some triangles of the surface face the light and others don't.
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
highp vec3 mapPoint; // the point to look up

// Sets mapPoint: v_mapPosition, moved towards the light by the error of interpolation. Rasterisers
// compute from the picture's corner. So the rounding of a surface seen from its edge, which changes
// much from pixel to pixel, may put a point behind it. A caster is thinner than rounding to a light
// that lies nearly in its plane. Its points are moved off it towards the eye, which is on the
// light's side wherever the map is queried (docs/method.md, C35).
void findMapPoint() {
    mapPoint = v_mapPosition;
#ifdef PRIMITIVE_MAP_POINTS
    // Nothing is moved, because the light's places may be on different sides of a triangle. The
    // error that rounding may have caused decides whether a point lies in a triangle's plane.
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
    highp vec3 normal = cross(along, up) * u_mapHand; // on the eye's side
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

#ifdef PRIMITIVE_MAP_POINTS
// Number of places, of 16, that are seen from the point. `casts`: see primitiveListIsEmpty().
float placesSeen(highp vec3 point, bool casts) {
    highp float all = 0.0;
    for (int k = 0; k < 4; ++k)
        all += sumOf(u_placesCounted[k]);
    if (!findPrimitiveTexel(point)) return all;
    if (primitiveDepth - pointError > primitiveHeader.x) return 0.0;
    return primitiveListIsEmpty(casts) ? all : placesLeft(point, casts);
}
#endif

// 1 or 0; with PRIMITIVE_MAP_POINTS the number of the light's places that reach the fragment.
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
uniform mediump sampler2D u_visibility; // a share in red; in green, 255ths of red's unit
uniform vec2 u_visibilityTexel;         // 1 / pixels

float seenOfLight() {
    vec2 share = texture2D(u_visibility, gl_FragCoord.xy * u_visibilityTexel).rg;
    return share.r + share.g / 255.0;
}
#endif

// Prepares the shadow's lookup, and returns the `lit` of lightThrough(). Call it first in main(), as
// derivatives need the neighbouring fragments.
float lightBeforeDiscard() {
#ifdef PRIMITIVE_MAP
    findMapPoint();
#endif
#ifdef COARSE_MASK
    return litByCoarseMask(u_casts > 0.5);
#else
    return 1.0;
#endif
}

vec3 towardsLight() {
#ifdef DIRECTIONAL
    return u_towardsLight;
#else
    // Scaled before it is squared, so that distant lights don't overflow.
    return normalize(v_towardsLight / max(max(abs(v_towardsLight.x), abs(v_towardsLight.y)),
                                          max(abs(v_towardsLight.z), 1e-30)));
#endif
}

// The share of the light that shadow lets through, 0..1. `lit`: the result of a mask of lower
// resolution; `normal` points towards the eye; `weight`: 0 where the light adds nothing.
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
