// Base colour times ambient light or, with LIT, times the Lambert term of one light as far as it
// reaches, in the display's own (sRGB) values; the lit pass adds one light at a time. WITH_AMBIENT,
// of LIT, both at once, and the ambient share of their sum in alpha. Other variants: MASK, the lit
// mask instead of colours; TEXTURED; COLORED, with colours at vertices; ALPHA_TEST, materials with
// cutouts; BLENDED, see-through ones; SLICED, nothing deeper than u_farthest. Of LIT: DIRECTIONAL,
// a light of one direction; RANGED and SPOT, one that doesn't reach everywhere, see
// light_window.glsl; MAP, lit as far as the light's shadow map says, with MAP_DIRECTIONAL and PCF as in shadow_map_lookup.glsl; COARSE_MASK,
// lit as far as a mask of lower resolution says; PRIMITIVE_MAP, as a primitive map says, see
// primitive_map_lookup.glsl, with PRIMITIVE_MAP_TINT showing what its texels hold.
#ifdef COARSE_MASK
#extension GL_OES_standard_derivatives : enable
#endif
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform vec4 u_baseColor; // sRGB
#ifdef COLORED
varying vec4 v_color;
#endif
#ifdef TEXTURED
uniform sampler2D u_texture;
varying vec2 v_texcoord;
#endif
#ifdef ALPHA_TEST
uniform float u_alphaCutoff;
#endif
#ifdef MASK
uniform float u_maskValue;
#endif
#ifdef LIT
uniform float u_diffuse;
uniform float u_mirrored; // 1, or -1 where the node's transform turns triangles over
varying vec3 v_normal;
#ifdef DIRECTIONAL
uniform vec3 u_towardsLight; // of length 1
#else
varying vec3 v_towardsLight;
#endif
#endif
#if !defined(LIT) || defined(WITH_AMBIENT)
uniform float u_ambient;
#endif
#ifdef SLICED
uniform float u_farthest;
varying float v_depth;
#endif

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
uniform float u_lightSide; // the light is on the front (1) or the back (-1) of these casters; 0: the
                           // surface is no caster
varying vec3 v_mapPosition;
#endif

#ifdef PRIMITIVE_MAP
#ifdef PRIMITIVE_MAP_TINT
// Blue where a texel's depth alone says dark, from green to red the more triangles are asked, none
// where none is.
vec4 primitiveTint() {
    if (!findPrimitiveTexel(v_mapPosition)) return vec4(0.0);
    if (primitiveDepth > primitiveHeader.x) return vec4(0.1, 0.2, 0.9, 0.6);
    float asked = primitiveCount(u_lightSide > 0.0);
    float many = min(asked / 8.0, 1.0);
    return vec4(many, 1.0 - many, 0.0, asked > 0.0 ? 0.6 : 0.0);
}
#endif

bool litByPrimitives() {
    float seenSide = gl_FrontFacing ? u_mirrored : -u_mirrored;
    if (seenSide * u_lightSide < 0.0) return false;
    return primitiveMapLights(v_mapPosition, u_lightSide > 0.0);
}
#endif

#ifdef LIT
#include "light_window.glsl"

vec3 towardsLight() {
#ifdef DIRECTIONAL
    return u_towardsLight;
#else
    // Scaled before it is squared, so that far-off lights don't overflow.
    return normalize(v_towardsLight / max(max(abs(v_towardsLight.x), abs(v_towardsLight.y)),
                                          max(abs(v_towardsLight.z), 1e-30)));
#endif
}

// The light's share of a colour; nothing in the mask where it doesn't reach, which knows no half
// shadow.
float shareOfLight(float lit) {
    vec3 light = towardsLight();
    vec3 normal = normalize(v_normal * (gl_FrontFacing ? u_mirrored : -u_mirrored));
    float lambert = max(dot(normal, light), 0.0);
#ifdef MAP
    if (lambert > 0.0)
        lit = lightFromMap(normal, light);
    else
        lit = u_casts > 0.5 ? 0.0 : lightFromMap(-normal, light);
#endif
    float window = lightWindow();
#ifdef PRIMITIVE_MAP
#ifndef MASK
    if (lambert * window > 0.0)
#endif
        lit = litByPrimitives() ? 1.0 : 0.0;
#endif
#ifdef MASK
    return window > 0.0 ? step(0.5, lit) : 0.0;
#else
    return u_diffuse * lambert * window * lit;
#endif
}
#endif

void main() {
    float lit = 1.0;
#ifdef COARSE_MASK
    lit = litByCoarseMask(u_casts > 0.5); // first: derivatives need their neighbours
#endif
#ifdef SLICED
    if (v_depth > u_farthest) discard;
#endif
    vec4 base = u_baseColor;
#ifdef COLORED
    base *= v_color;
#endif
#ifdef TEXTURED
    base *= texture2D(u_texture, v_texcoord);
#endif
#ifdef ALPHA_TEST
    if (base.a < u_alphaCutoff) discard;
#endif
#if defined(LIT)
    float share = shareOfLight(lit);
#elif defined(MASK)
    float share = 1.0;
#else
    float share = u_ambient;
#endif
#if defined(BLENDED)
    float alpha = base.a;
#elif defined(WITH_AMBIENT)
    share += u_ambient;
    float alpha = share > 0.0 ? u_ambient / share : 1.0;
#else
    float alpha = 1.0;
#endif
#ifdef MASK
    gl_FragColor = vec4(vec3(u_maskValue * share), alpha);
#else
    gl_FragColor = vec4(base.rgb * share, alpha);
#endif
#ifdef PRIMITIVE_MAP_TINT
    vec4 tint = primitiveTint();
    gl_FragColor.rgb = mix(gl_FragColor.rgb, tint.rgb, tint.a);
#endif
}
