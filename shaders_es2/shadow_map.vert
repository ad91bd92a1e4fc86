// Casters as a light sees them, for its shadow map. Variant ALPHA_TEST: alpha-tested materials.
#include "extrusion.glsl"

attribute vec3 a_position;
#ifdef ALPHA_TEST
attribute vec2 a_texcoord;
attribute vec4 a_color;
#endif

uniform mat4 u_clipFromObject;
uniform mat4 u_mapFromObject; // see ShadowMapView

varying vec3 v_mapPosition;
#ifdef ALPHA_TEST
varying vec2 v_texcoord;
varying float v_alphaLookup;
#endif

void main() {
    v_mapPosition = clipPosition(u_mapFromObject, vec4(a_position, 1.0)).xyz;
#ifdef ALPHA_TEST
    v_texcoord = a_texcoord;
    v_alphaLookup = a_color.a;
#endif
    gl_Position = clipPosition(u_clipFromObject, vec4(a_position, 1.0));
}
