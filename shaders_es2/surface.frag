// Base colour times ambient plus Lambert light as far as the light reaches, in the display's own (sRGB) values. The lit pass
// adds one light at a time. Variants: ALPHA_TEST, materials with holes; BLENDED, see-through ones;
// MAP, lit as far as the light's shadow map says, with MAP_SUN and PCF as in
// shadow_map_lookup.glsl; COARSE_MASK, lit as far as a mask of lower resolution says; SLICED, nothing
// deeper than u_farthest.
#ifdef COARSE_MASK
#extension GL_OES_standard_derivatives : enable
#endif
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform sampler2D u_texture;
uniform vec4 u_baseColor;   // sRGB
uniform float u_ambient;
uniform float u_diffuse;
uniform float u_inverseRange; // of the light; 0: it reaches everywhere
uniform float u_mirrored;   // 1, or -1 where the node's transform turns triangles over
uniform float u_mask;       // 1: draw u_maskValue, for the lit mask
uniform float u_maskValue;
#ifdef ALPHA_TEST
uniform float u_alphaCutoff;
#endif

varying vec3 v_normal;
varying vec3 v_towardsLight;
varying vec2 v_texcoord;
varying vec4 v_color;
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

void main() {
    float lit = 1.0;
#ifdef COARSE_MASK
    lit = litByCoarseMask(u_casts > 0.5); // first: derivatives need their neighbours
#endif
#ifdef SLICED
    if (v_depth > u_farthest) discard;
#endif
    vec4 base = u_baseColor * v_color * texture2D(u_texture, v_texcoord);
#ifdef ALPHA_TEST
    if (base.a < u_alphaCutoff) discard;
#endif
    // Scaled before it is squared, so that far-off lights don't overflow.
    vec3 light = v_towardsLight / max(max(abs(v_towardsLight.x), abs(v_towardsLight.y)),
                                      max(abs(v_towardsLight.z), 1e-30));
    light = normalize(light);
    vec3 normal = normalize(v_normal * (gl_FrontFacing ? u_mirrored : -u_mirrored));
    float lambert = max(dot(normal, light), 0.0);
#ifdef MAP
    if (lambert > 0.0)
        lit = lightFromMap(normal, light);
    else
        lit = u_casts > 0.5 ? 0.0 : lightFromMap(-normal, light);
#endif
    vec3 reached = v_towardsLight * u_inverseRange;
    float share = dot(reached, reached);
    float window = max(1.0 - share * share, 0.0); // see Light
    vec3 shaded = base.rgb * (u_ambient + u_diffuse * lambert * window * lit);
#ifdef BLENDED
    float alpha = base.a;
#else
    float alpha = 1.0;
#endif
    // The mask knows no half shadow.
    float isLit = window > 0.0 ? step(0.5, lit) : 0.0;
    gl_FragColor = vec4(mix(shaded, vec3(u_maskValue * isLit), u_mask), alpha);
}
