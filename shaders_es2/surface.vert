// Visible surfaces, in every pass: the depth test EQUAL of the lit pass needs the same positions,
// so gl_Position is invariant and depends on nothing that a variant changes. Variants LIT,
// DIRECTIONAL, TEXTURED, COLORED, SPOT, MAP, PRIMITIVE_MAP and SLICED: see surface.frag; PLANE: see
// coarse_plane.glsl.
#include "extrusion.glsl"

attribute vec3 a_position;
#ifdef COLORED
attribute vec4 a_color;
#endif
#ifdef TEXTURED
attribute vec2 a_texcoord;
#endif
#ifdef LIT
attribute vec3 a_normal;
#endif

uniform mat4 u_clipFromObject;
#ifdef LIT
uniform mat3 u_normalFromObject;
#ifndef DIRECTIONAL
uniform mat4 u_eyeOffsetFromObject; // to world axes, origin at the eye
uniform vec3 u_light;               // the same space
#endif
#endif
#ifdef SPOT
uniform mat4 u_coneFromObject;      // see coneFromWorld()
#endif
#if defined(MAP) || defined(PRIMITIVE_MAP)
uniform mat4 u_mapFromObject;       // see ShadowMapView, LightTiles
#endif

invariant gl_Position;

#ifdef COLORED
varying vec4 v_color;
#endif
#ifdef TEXTURED
varying vec2 v_texcoord;
#endif
#ifdef LIT
varying vec3 v_normal;
#ifndef DIRECTIONAL
varying vec3 v_towardsLight;
#endif
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
#ifdef PLANE
varying vec3 v_clip;
#endif

void main() {
#ifdef COLORED
    v_color = a_color;
#endif
#ifdef TEXTURED
    v_texcoord = a_texcoord;
#endif
#ifdef LIT
    v_normal = u_normalFromObject * a_normal;
#ifndef DIRECTIONAL
    v_towardsLight = u_light - (u_eyeOffsetFromObject * vec4(a_position, 1.0)).xyz;
#endif
#endif
#ifdef SPOT
    v_cone = clipPosition(u_coneFromObject, vec4(a_position, 1.0)).xyz;
#endif
#if defined(MAP) || defined(PRIMITIVE_MAP)
    v_mapPosition = clipPosition(u_mapFromObject, vec4(a_position, 1.0)).xyz;
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
