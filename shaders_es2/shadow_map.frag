// Writes a caster's distance from the light. Variants: MAP_DIRECTIONAL, one flat map; ALPHA_TEST.
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif
#include "shadow_map_distance.glsl"

#ifdef ALPHA_TEST
uniform sampler2D u_texture;
uniform float u_alphaScale;
uniform float u_alphaCutoff;
varying vec2 v_texcoord;
varying float v_alphaLookup;
#endif

varying vec3 v_mapPosition;

void main() {
#ifdef ALPHA_TEST
    if (texture2D(u_texture, v_texcoord).a * u_alphaScale * v_alphaLookup < u_alphaCutoff) discard;
#endif
#ifdef MAP_DIRECTIONAL
    gl_FragColor = packDistance(v_mapPosition.z);
#else
    gl_FragColor = packDistance(length(v_mapPosition));
#endif
}
