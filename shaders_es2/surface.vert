// Visible surfaces, in every pass. The depth test EQUAL of the lit pass needs the same positions,
// so gl_Position is invariant and depends on nothing that a variant changes. Variants LIT,
// DIRECTIONAL, PLAIN, COLORED, SPOT, MAP, PRIMITIVE_MAP, SIDED and SLICED: see surface.frag and
// light.glsl; MATERIAL: for material.frag; TANGENTS: see material_maps.glsl; ALPHA_LOOKUP: see
// surface.frag; SOFT_TERMINATOR: see terminator.glsl; LIGHT_LIST: see light_table.glsl; PLANE: see
// coarse_plane.glsl. TEXCOORDS, bits: 1, the first set of texture coordinates; 2, the second; 4, the
// third and the fourth.
#include "extrusion.glsl"
#ifndef TEXCOORDS
#define TEXCOORDS 0
#endif

attribute vec3 a_position;
#ifdef COLORED
attribute vec4 a_color;
#endif
#if (TEXCOORDS & 1) != 0
attribute vec2 a_texcoord;
#ifdef ALPHA_LOOKUP
uniform mat3 u_texcoordTransform;
#endif
#endif
#if (TEXCOORDS & 2) != 0
attribute vec2 a_texcoord1;
#endif
#if (TEXCOORDS & 4) != 0
attribute vec4 a_texcoord23;
#endif
#if defined(LIT) || defined(PLAIN) || defined(MATERIAL) || defined(LIGHT_LIST)
#define NORMAL
attribute vec3 a_normal;
#endif
#ifdef TANGENTS
attribute vec4 a_tangent; // w: the bitangent's sign
#endif

#ifdef SIDED
attribute float a_lightSide;
#endif

uniform mat4 u_clipFromObject;
#ifdef NORMAL
uniform mat3 u_normalFromObject;
#endif
#if defined(MATERIAL) || defined(SOFT_TERMINATOR) || defined(LIGHT_LIST)
#define SHOWS_FROM_EYE
#endif
#if (defined(LIT) && !defined(DIRECTIONAL)) || defined(SHOWS_FROM_EYE)
#define FROM_EYE
uniform mat4 u_eyeOffsetFromObject; // to world axes, origin at the eye
#endif
#if defined(LIT) && !defined(DIRECTIONAL)
uniform vec3 u_light; // in the same space
#endif
#ifdef SPOT
uniform mat4 u_coneFromObject;      // see coneFromWorld()
#endif
#if defined(MAP) || defined(PRIMITIVE_MAP)
uniform mat4 u_mapFromObject;       // see ShadowMapView, LightTiles
#endif
#ifdef PRIMITIVE_MAP
uniform vec3 u_mapOrigin;     // the point that the map puts at 0: a point light's position
uniform vec3 u_mapOriginRest; // the part of it that rounding lost
#endif

invariant gl_Position;

#ifdef COLORED
varying vec4 v_color;
#endif
#if (TEXCOORDS & 1) != 0
varying vec2 v_texcoord;
#endif
#if (TEXCOORDS & 2) != 0
varying vec2 v_texcoord1;
#endif
#if (TEXCOORDS & 4) != 0
varying vec4 v_texcoord23;
#endif
#ifdef NORMAL
varying vec3 v_normal;
#endif
#ifdef TANGENTS
varying vec4 v_tangent;
#endif
#ifdef SHOWS_FROM_EYE
varying vec3 v_fromEye;
#endif
#if defined(LIT) && !defined(DIRECTIONAL)
varying vec3 v_towardsLight;
#endif
#ifdef SPOT
varying vec3 v_cone;
#endif
#ifdef SLICED
varying float v_depth; // along the viewing direction
#endif
#if defined(MAP) || defined(PRIMITIVE_MAP)
varying vec3 v_mapPosition;
#endif
#if defined(PRIMITIVE_MAP) && !defined(PRIMITIVE_MAP_DIRECTIONAL)
varying float v_mapReach; // distance of its vertices from the light, which scales their rounding
#endif
#ifdef SIDED
varying float v_lightSide;
#endif
#ifdef PLANE
varying vec3 v_clip;
#endif

void main() {
#ifdef COLORED
    v_color = a_color;
#endif
#if (TEXCOORDS & 1) != 0
#ifdef ALPHA_LOOKUP
    v_texcoord = (u_texcoordTransform * vec3(a_texcoord, 1.0)).xy;
#else
    v_texcoord = a_texcoord;
#endif
#endif
#if (TEXCOORDS & 2) != 0
    v_texcoord1 = a_texcoord1;
#endif
#if (TEXCOORDS & 4) != 0
    v_texcoord23 = a_texcoord23;
#endif
#ifdef NORMAL
    v_normal = u_normalFromObject * a_normal;
#endif
#ifdef FROM_EYE
    vec3 fromEye = (u_eyeOffsetFromObject * vec4(a_position, 1.0)).xyz;
#endif
#ifdef TANGENTS
    v_tangent = vec4(mat3(u_eyeOffsetFromObject) * a_tangent.xyz, a_tangent.w);
#endif
#ifdef SHOWS_FROM_EYE
    v_fromEye = fromEye;
#endif
#if defined(LIT) && !defined(DIRECTIONAL)
    v_towardsLight = u_light - fromEye;
#endif
#ifdef SPOT
    v_cone = clipPosition(u_coneFromObject, vec4(a_position, 1.0)).xyz;
#endif
#ifdef PRIMITIVE_MAP
    // Near the origin no digits cancel.
    vec3 fromOrigin = (a_position - u_mapOrigin) - u_mapOriginRest;
    v_mapPosition = clipPosition(u_mapFromObject, vec4(fromOrigin, 0.0)).xyz;
#ifndef PRIMITIVE_MAP_DIRECTIONAL
    vec3 reach = abs(v_mapPosition);
    v_mapReach = max(reach.x, max(reach.y, reach.z));
#endif
#elif defined(MAP)
    v_mapPosition = clipPosition(u_mapFromObject, vec4(a_position, 1.0)).xyz;
#endif
#ifdef SIDED
    v_lightSide = a_lightSide;
#endif
    gl_Position = rasterizable(u_clipFromObject, clipPosition(u_clipFromObject, vec4(a_position, 1.0)));
#ifdef SLICED
    v_depth = gl_Position.w;
#endif
#ifdef PLANE
#ifdef ORTHOGRAPHIC
    v_clip = gl_Position.xyz;
#else
    v_clip = gl_Position.xyw;
#endif
#endif
}
