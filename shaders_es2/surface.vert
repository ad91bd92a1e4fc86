// Visible surfaces, in every pass: the depth test EQUAL of the lit pass needs the same positions, so
// gl_Position is invariant and depends on nothing that a variant changes. Variants MAP and SLICED:
// see surface.frag; PLANE: see coarse_plane.glsl.
#include "extrusion.glsl"

attribute vec3 a_position;
attribute vec3 a_normal;
attribute vec2 a_texcoord;
attribute vec4 a_color;

uniform mat4 u_clipFromObject;
uniform mat4 u_eyeOffsetFromObject; // to world axes, origin at the eye
uniform mat3 u_normalFromObject;
uniform vec4 u_light;               // the same space
#ifdef MAP
uniform mat4 u_mapFromObject;       // see ShadowMapView
#endif

invariant gl_Position;

varying vec3 v_normal;
varying vec3 v_towardsLight;
varying vec2 v_texcoord;
varying vec4 v_color;
#ifdef SLICED
varying float v_depth; // along the viewing direction
#endif
#ifdef MAP
varying vec3 v_mapPosition;
#endif
#ifdef PLANE
varying vec3 v_clip;
#endif

void main() {
    vec3 p = (u_eyeOffsetFromObject * vec4(a_position, 1.0)).xyz;
    v_normal = u_normalFromObject * a_normal;
    v_towardsLight = u_light.xyz - p * u_light.w;
    v_texcoord = a_texcoord;
    v_color = a_color;
#ifdef MAP
    v_mapPosition = clipPosition(u_mapFromObject, vec4(a_position, 1.0)).xyz;
#endif
    gl_Position = rasterizable(clipPosition(u_clipFromObject, vec4(a_position, 1.0)));
#ifdef SLICED
    v_depth = gl_Position.w;
#endif
#ifdef PLANE
    v_clip = gl_Position.xyw;
#endif
}
