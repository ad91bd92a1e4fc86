// Base colour times ambient light or, with LIT, times the Lambert term of one light as far as it
// reaches, in the display's own (sRGB) values; the lit pass adds one light at a time. WITH_AMBIENT,
// with LIT: both at once, and alpha holds the ambient share of their sum.
//
// Other variants: PLAIN, the same but adding up light itself, of which the display shows a power;
// SOFT_TERMINATOR, see terminator.glsl; MASK, the lit mask instead of colours; TEXTURED; COLORED,
// with colours at vertices; CATCHER, with COLORED, a ground that shows the background and the
// shadow on it, which is the stronger the larger its vertices' alpha; ALPHA_TEST, materials with
// cutouts; ALPHA_LOOKUP, alpha from a host's texture, which may hold it in another channel;
// BLENDED, see-through surfaces; LINEAR, the light that is later mapped to such colours; SLICED, see
// slice.glsl; LIGHT_LIST, all lights of a tile's list in place of one light, see light_table.glsl.
// With LIT those of light.glsl, and PRIMITIVE_MAP_TINT, which shows the contents of a primitive
// map's texels.
#ifdef DERIVATIVES
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
#ifdef ALPHA_LOOKUP
uniform vec4 u_alphaChannel; // 1 in the channel that holds alpha
#endif
#ifdef ALPHA_TEST
uniform float u_alphaCutoff;
#endif
#ifdef MASK
uniform float u_maskValue;
#endif
#if defined(LIT) || defined(PLAIN) || defined(LIGHT_LIST)
#include "facing.glsl"
#endif
#ifdef LIGHT_LIST
uniform float u_diffuse;
#include "eye.glsl"
#include "light_table.glsl"
#endif
#ifdef LIT
uniform float u_diffuse;
#include "light.glsl"
#ifdef SOFT_TERMINATOR
#include "eye.glsl"
#include "terminator.glsl"
#endif
#endif
#if (!defined(LIT) && !defined(LIGHT_LIST)) || defined(WITH_AMBIENT)
#define SHOWS_AMBIENT
uniform float u_ambient;
#endif
#ifdef PLAIN
uniform float u_ambientSlope; // how much more ambient light comes from above than from the side
uniform float u_exposure;

// The display value of a share of light, relative to a colour shown unchanged in full light. A pure
// power, so that shadow dims all of a colour's channels by the same share.
float displayed(float share) { return pow(max(share, 0.0) * u_exposure, 1.0 / 2.2); }
#endif
#ifdef LINEAR
#include "tone_mapping.glsl"
#include "tone_inverse.glsl"
#endif
#include "slice.glsl"

#ifdef PRIMITIVE_MAP_TINT
// Blue where a texel's depth alone makes it dark; from green to red the more triangles the texel
// lists for the point; no tint where it lists none.
vec4 primitiveTint() {
    if (!findPrimitiveTexel(v_mapPosition)) return vec4(0.0);
    if (primitiveDepth > primitiveHeader.x) return vec4(0.1, 0.2, 0.9, 0.6);
    float many = min(primitiveListLength(LIGHT_SIDE > 0.0) / 8.0, 1.0);
    return vec4(many, 1.0 - many, 0.0, many > 0.0 ? 0.6 : 0.0);
}
#endif

#ifdef LIT
// The light's share of a colour. In the mask, 0 where the light doesn't reach; the mask has half
// shadow only for lights with an extent.
float shareOfLight(float lit, vec3 normal) {
    vec3 light = towardsLight();
    float lambert = max(dot(normal, light), 0.0);
#ifdef CATCHER
    lambert = lambert > 0.0 ? 1.0 : 0.0; // a lit ground is as bright as the background
#endif
#ifdef SOFT_TERMINATOR
    lambert *= lightAtTerminator(normal, light);
#endif
    float window = lightWindow();
    lit = lightThrough(lit, normal, light, lambert * window);
#ifdef MASK
#if defined(VISIBILITY) || defined(SOFT_MAP) || defined(PRIMITIVE_MAP_POINTS)
    return window > 0.0 ? lit : 0.0;
#else
    return window > 0.0 ? step(0.5, lit) : 0.0;
#endif
#else
    return u_diffuse * lambert * window * lit;
#endif
}
#endif

#ifdef LIGHT_LIST
// Share of all lights that the fragment's tile lists.
float shareOfLights(vec3 normal) {
    highp vec2 list = lightListHere();
    float share = 0.0;
    for (int i = 0; i < LIGHT_LIST; ++i) {
        if (float(i) >= list.y) break;
        vec3 light, color;
        float window = listedLight(list.x + float(i), light, color);
        float lambert = max(dot(normal, light), 0.0);
#ifdef CATCHER
        lambert = lambert > 0.0 ? 1.0 : 0.0;
#endif
        share += lambert * window;
    }
    return u_diffuse * share;
}
#endif

void main() {
#ifdef LIT
    float lit = lightBeforeDiscard();
#endif
    discardBeyondSlice();
    vec4 base = u_baseColor;
#if defined(COLORED) && !defined(CATCHER)
    base *= v_color;
#endif
#ifdef TEXTURED
    vec4 texel = texture2D(u_texture, v_texcoord);
#ifdef ALPHA_LOOKUP
    texel.a = dot(texel, u_alphaChannel);
#endif
    base *= texel;
#endif
#ifdef ALPHA_TEST
    if (base.a < u_alphaCutoff) discard;
#endif
#if defined(LIT) || defined(PLAIN) || defined(LIGHT_LIST)
    vec3 normal = normalize(v_normal * facing());
#endif
#ifdef SHOWS_AMBIENT
    float ambient = u_ambient;
#ifdef PLAIN
    ambient += u_ambientSlope * normal.y;
#endif
#endif
#ifdef CATCHER
    float strength = smoothstep(0.0, 1.0, v_color.a);
#ifdef SHOWS_AMBIENT
    ambient = 1.0 - strength * (1.0 - ambient);
#endif
#endif
#if defined(LIT) || defined(LIGHT_LIST)
#ifdef LIT
    float share = shareOfLight(lit, normal);
#else
    float share = shareOfLights(normal);
#endif
#ifdef CATCHER
    share *= strength;
#endif
#elif defined(MASK)
    float share = 1.0;
#else
    float share = ambient;
#endif
#if defined(LIT) && defined(WITH_AMBIENT)
    share += ambient;
#endif
#ifdef PLAIN
    share = displayed(share);
#ifdef SHOWS_AMBIENT
    ambient = displayed(ambient);
#endif
#endif
#if defined(BLENDED)
    float alpha = base.a;
#elif defined(WITH_AMBIENT)
    float alpha = share > 0.0 ? ambient / share : 1.0;
#else
    float alpha = 1.0;
#endif
#ifdef MASK
    gl_FragColor = vec4(vec3(u_maskValue * share), alpha);
#else
#if defined(CATCHER) && defined(LINEAR)
    gl_FragColor = vec4(lightShownAs(base.rgb) * share, alpha);
#elif defined(LINEAR)
    gl_FragColor = vec4(lightShownAs(base.rgb * share), alpha);
#else
    gl_FragColor = vec4(base.rgb * share, alpha);
#endif
#endif
#ifdef PRIMITIVE_MAP_TINT
    vec4 tint = primitiveTint();
    gl_FragColor.rgb = mix(gl_FragColor.rgb, tint.rgb, tint.a);
#endif
}
