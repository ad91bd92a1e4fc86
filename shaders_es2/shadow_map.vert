// Casters as a light sees them, for its shadow map. Variants: MAP_PARABOLOID, one half of all
// directions in a paraboloid mirror (Brabec et al. 2002), exact only at vertices: edges stay
// straight; MAP_WARPED, casters already cut and placed for a warped map (WarpCuts); ALPHA_TEST,
// alpha-tested materials.
#include "extrusion.glsl"

attribute vec3 a_position;
#ifdef ALPHA_TEST
attribute vec2 a_texcoord;
attribute vec4 a_color;
#endif

#ifdef MAP_PARABOLOID
uniform float u_halfSide; // 1: upwards, -1: downwards
uniform float u_mapShare; // see shadow_map_faces.glsl
#elif !defined(MAP_WARPED)
uniform mat4 u_clipFromObject;
#endif
uniform mat4 u_mapFromObject; // see ShadowMapView

varying vec3 v_mapPosition;
#ifdef ALPHA_TEST
varying vec2 v_texcoord;
varying float v_alphaLookup;
#endif

void main() {
#ifdef MAP_WARPED
    v_mapPosition = a_position;
#else
    v_mapPosition = clipPosition(u_mapFromObject, vec4(a_position, 1.0)).xyz;
#endif
#ifdef ALPHA_TEST
    v_texcoord = a_texcoord;
    v_alphaLookup = a_color.a;
#endif
#ifdef MAP_PARABOLOID
    // Homogeneous, so that a point far in the other half, infinitely far out, is clipped.
    float distance = max(length(v_mapPosition), 1e-30);
    vec3 towards = v_mapPosition / distance;
    float w = 1.0 + u_halfSide * towards.y;
    gl_Position = vec4(u_mapShare * towards.xz, (2.0 * distance - 1.0) * w, w);
#elif defined(MAP_WARPED)
    gl_Position = vec4(2.0 * a_position - 1.0, 1.0);
#else
    gl_Position = clipPosition(u_clipFromObject, vec4(a_position, 1.0));
#endif
}
