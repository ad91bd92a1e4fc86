// Surfaces as their materials describe them (glTF 2.0, appendix B), in linear light. AMBIENT: light
// from everywhere that they reflect, and light that they emit; LIT: one light; or both. Writes the
// display's colours or, with LINEAR, light itself, which is mapped later. BLENDED: see-through
// surfaces, colours times alpha.
//
// Variants that a material needs: COLORED, ALPHA_TEST as in surface.frag; GLOSSY,
// specular-glossiness; CLEARCOAT; and those of material_maps.glsl.
//
// SOFT_TERMINATOR, with one light or a list: see terminator.glsl. LIGHT_LIST: all lights of a tile's
// list in place of LIT, see light_table.glsl. SLICED: see slice.glsl. With LIT also the variants of
// light.glsl.
#ifdef DERIVATIVES
#extension GL_OES_standard_derivatives : enable
#endif
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform vec4 u_baseColor; // linear
uniform float u_exposure;
#ifdef COLORED
varying vec4 v_color;
#endif
#ifdef ALPHA_TEST
uniform float u_alphaCutoff;
#endif
#ifdef BLENDED
uniform float u_transmission;
#endif
#ifdef AMBIENT
uniform float u_ambient; // what a white surface reflects of light from everywhere, on average
#include "environment.glsl"
#endif

#include "slice.glsl"
#include "facing.glsl"
#include "eye.glsl"
#include "tone_mapping.glsl"
#include "brdf.glsl"
#include "material_maps.glsl"
#ifdef LIT
uniform vec3 u_lightColor; // what a white Lambert surface reflects of it at normal incidence
#include "light.glsl"
#endif
#ifdef LIGHT_LIST
#include "light_table.glsl"
#endif
#include "terminator.glsl"

// The surface at the fragment, on the eye's side.
struct Surface {
    vec3 toEye;
    vec3 normal;
    vec3 diffuse;
    vec3 reflectance; // at normal incidence
    float grazingReflectance;
    vec2 dielectric; // keeps light from being scattered: both of these, without the metal's part
    float roughness;
#ifdef CLEARCOAT
    vec3 coatNormal;
    float coat;
    float coatRoughness;
#endif
};

float strongest(vec3 color) { return max(color.r, max(color.g, color.b)); }

vec4 baseColor() {
    vec4 base = u_baseColor;
#ifdef COLORED
    base *= vec4(linearFromSrgb(v_color.rgb), v_color.a);
#endif
    return base * baseTexel();
}

Surface surfaceOf(vec3 base) {
    Surface surface;
    surface.toEye = normalize(towardsEye());
    float size = dot(v_normal, v_normal);
    vec3 geometric = size > 0.0 ? v_normal * inversesqrt(size) : surface.toEye;
    surface.normal = facing() * normalHere(geometric);
    Reflectance here = reflectanceHere();
#ifdef GLOSSY
    surface.reflectance = here.specularColor;
    surface.grazingReflectance = 1.0;
    surface.dielectric = vec2(strongest(here.specularColor), 1.0);
    surface.diffuse = base * (1.0 - surface.dielectric.x);
#else
    vec3 dielectric = min(u_reflectance.z * here.specularColor, vec3(1.0)) * here.specular;
    surface.reflectance = mix(dielectric, base, here.metallic);
    surface.grazingReflectance = mix(here.specular, 1.0, here.metallic);
    surface.dielectric = vec2(strongest(dielectric), here.specular);
    surface.diffuse = base * (1.0 - here.metallic);
#endif
    // A perfect mirror wouldn't show a point light.
    surface.roughness = clamp(here.roughness, 0.05, 1.0);
#ifdef CLEARCOAT
    surface.coat = coatHere();
    surface.coatNormal = facing() * coatNormalHere(geometric);
    surface.coatRoughness = clamp(coatRoughnessHere(), 0.05, 1.0);
#endif
    return surface;
}

// Light that a surface sends to the eye: scattered, which transmission reduces, and reflected.
struct Seen {
    vec3 scattered;
    vec3 reflected;
};

#ifdef CLEARCOAT
// Share of the light that the coat passes to and from what is beneath it.
float beneathCoat(Surface surface) {
    float nv = max(dot(surface.coatNormal, surface.toEye), 0.0);
    return 1.0 - surface.coat * (0.04 + 0.96 * grazing(nv));
}
#endif

#if defined(LIT) || defined(LIGHT_LIST)
// Adds light from one direction; `color` is 1 for what a white Lambert surface reflects at normal
// incidence.
void addLight(Surface surface, vec3 light, vec3 color, inout Seen seen) {
    vec3 halfway = normalize(light + surface.toEye);
    float nl = max(dot(surface.normal, light), 0.0);
    float nv = max(dot(surface.normal, surface.toEye), 1e-4);
    float nh = max(dot(surface.normal, halfway), 0.0);
    float weight = grazing(dot(light, halfway));
    vec3 reflectance =
        mix(surface.reflectance, vec3(surface.grazingReflectance), weight);
    float alpha = surface.roughness * surface.roughness;
    vec3 scattered =
        surface.diffuse * ((1.0 - mix(surface.dielectric.x, surface.dielectric.y, weight)) * nl);
    vec3 mirrored = reflectance * (microfacets(alpha, nl, nv, nh) * nl);
#ifdef CLEARCOAT
    float left = beneathCoat(surface);
    float coatAlpha = surface.coatRoughness * surface.coatRoughness;
    float coatNl = max(dot(surface.coatNormal, light), 0.0);
    float coatNv = max(dot(surface.coatNormal, surface.toEye), 1e-4);
    float coatNh = max(dot(surface.coatNormal, halfway), 0.0);
    float coat = surface.coat * (0.04 + 0.96 * weight) *
                 microfacets(coatAlpha, coatNl, coatNv, coatNh) * coatNl;
    scattered *= left;
    mirrored = mirrored * left + vec3(coat);
#endif
    seen.scattered += scattered * color;
    seen.reflected += mirrored * color;
}
#endif

#ifdef AMBIENT
// Adds light from everywhere, including multiple reflection between facets (Fdez-Aguera, A
// multiple-scattering microfacet model, 2019).
void addAmbient(Surface surface, float occlusion, inout Seen seen) {
    float nv = clamp(dot(surface.normal, surface.toEye), 0.0, 1.0);
    vec2 share = reflectedFromEverywhere(surface.roughness, nv);
    vec3 once = surface.reflectance * share.x + vec3(surface.grazingReflectance * share.y);
    float lost = 1.0 - share.x - share.y;
    vec3 average = mix(surface.reflectance, vec3(surface.grazingReflectance), 1.0 / 21.0);
    vec3 again = once * average / (vec3(1.0) - lost * average) * lost;
    vec3 all = once + again;
    vec3 around = environmentDiffuse(surface.normal);
    vec3 mirror = environmentSpecular(reflect(-surface.toEye, surface.normal), surface.roughness);
    vec3 scattered = surface.diffuse * (1.0 - strongest(all)) * around;
    vec3 mirrored = once * mirror + again * around;
#ifdef CLEARCOAT
    float left = beneathCoat(surface);
    float coatNv = clamp(dot(surface.coatNormal, surface.toEye), 0.0, 1.0);
    vec2 coatShare = reflectedFromEverywhere(surface.coatRoughness, coatNv);
    vec3 coatMirror = environmentSpecular(reflect(-surface.toEye, surface.coatNormal),
                                          surface.coatRoughness);
    scattered *= left;
    mirrored = mirrored * left + surface.coat * (0.04 * coatShare.x + coatShare.y) * coatMirror;
#endif
    seen.scattered += scattered * (u_ambient * occlusion);
    seen.reflected += mirrored * (u_ambient * occlusion);
}
#endif

void main() {
#ifdef LIT
    float lit = lightBeforeDiscard();
#endif
    discardBeyondSlice();
    vec4 base = baseColor();
#ifdef ALPHA_TEST
    if (base.a < u_alphaCutoff) discard;
#endif
    Surface surface = surfaceOf(base.rgb);
    Seen seen = Seen(vec3(0.0), vec3(0.0));
#ifdef AMBIENT
    addAmbient(surface, occlusionHere(), seen);
    vec3 emission = emissionHere();
#ifdef CLEARCOAT
    emission *= beneathCoat(surface);
#endif
    seen.reflected += emission;
#endif
#ifdef LIT
    vec3 light = towardsLight();
    float window = lightWindow();
    // The vertices' normal decides which side of the triangle is lit.
    vec3 side = v_normal * facing();
    float weight = window * max(dot(surface.normal, light), 0.0);
#ifdef CLEARCOAT
    weight = max(weight, window * max(dot(surface.coatNormal, light), 0.0));
#endif
    lit = lightThrough(lit, normalize(side), light, weight);
    window *= lightAtTerminator(normalize(side), light);
    addLight(surface, light, u_lightColor * (window * lit), seen);
#endif
#ifdef LIGHT_LIST
    vec3 side = normalize(v_normal * facing());
    highp vec2 list = lightListHere();
    for (int i = 0; i < LIGHT_LIST; ++i) {
        if (float(i) >= list.y) break;
        vec3 light, color;
        float window = listedLight(list.x + float(i), light, color);
        window *= lightAtTerminator(side, light);
        addLight(surface, light, color * window, seen);
    }
#endif
#ifdef BLENDED
    seen.scattered *= 1.0 - u_transmission;
    float alpha = base.a * (1.0 - u_transmission);
#else
    float alpha = 1.0;
#endif
    vec3 color = (seen.scattered + seen.reflected) * u_exposure;
#ifndef LINEAR
    color = displayed(color);
#endif
#ifdef BLENDED
    color *= base.a;
#endif
    gl_FragColor = vec4(color, alpha);
}
