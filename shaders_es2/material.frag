// Surfaces as their materials describe them (glTF 2.0, appendix B), in linear light. AMBIENT: light
// from everywhere that they reflect, and light that they emit; LIT: one light; or both. Writes the
// display's colours or, with LINEAR, light itself, which is mapped later. BLENDED: see-through
// surfaces, colours times alpha.
//
// Variants that a material needs: TEXTURED, COLORED, ALPHA_TEST as in surface.frag;
// REFLECTANCE_MAP, metal and roughness by texture; GLOSSY, specular-glossiness; SPECULAR_MAP,
// SPECULAR_COLOR_MAP; NORMAL_MAP, with the vertices' TANGENTS or else by derivatives;
// OCCLUSION_MAP; EMISSIVE and EMISSIVE_MAP; CLEARCOAT with CLEARCOAT_MAP, CLEARCOAT_ROUGHNESS_MAP,
// CLEARCOAT_NORMAL_MAP. Each map's name + _UV names its texture coordinates.
//
// FALLOFF, with LIT: the light is in candela and falls off with the square of the distance.
// SOFT_TERMINATOR, with LIT: see terminator.glsl. LIGHT_LIST: all lights of a tile's list in place
// of LIT, see light_table.glsl. SLICED: discards whatever is deeper than u_farthest. With LIT also
// the variants of light.glsl.
#ifdef DERIVATIVES
#extension GL_OES_standard_derivatives : enable
#endif
#ifdef GL_FRAGMENT_PRECISION_HIGH
precision highp float;
#else
precision mediump float;
#endif

uniform vec4 u_baseColor;   // linear
uniform vec4 u_reflectance; // metallic, roughness, reflectance of dielectrics, specular
uniform vec3 u_specularColor;
uniform float u_exposure;
#ifdef COLORED
varying vec4 v_color;
#endif
#ifdef TEXCOORDS
varying vec2 v_texcoord;
#endif
#ifdef TEXCOORDS_1
varying vec2 v_texcoord1;
#endif
#ifdef TEXCOORDS_2
varying vec4 v_texcoord23;
#endif
#ifdef TANGENTS
varying vec4 v_tangent;
#endif
#ifdef TEXTURED
uniform sampler2D u_texture;
#endif
#ifdef REFLECTANCE_MAP
uniform sampler2D u_reflectanceMap;
#endif
#ifdef SPECULAR_MAP
uniform sampler2D u_specularMap;
#endif
#ifdef SPECULAR_COLOR_MAP
uniform sampler2D u_specularColorMap;
#endif
#ifdef NORMAL_MAP
uniform sampler2D u_normalMap;
uniform float u_normalScale;
#endif
#ifdef ALPHA_TEST
uniform float u_alphaCutoff;
#endif
#ifdef BLENDED
uniform float u_transmission;
#endif
#ifdef CLEARCOAT
uniform vec3 u_clearcoat; // amount, roughness, scale of its normals
#ifdef CLEARCOAT_MAP
uniform sampler2D u_clearcoatMap;
#endif
#ifdef CLEARCOAT_ROUGHNESS_MAP
uniform sampler2D u_clearcoatRoughnessMap;
#endif
#ifdef CLEARCOAT_NORMAL_MAP
uniform sampler2D u_clearcoatNormalMap;
#endif
#endif
#ifdef AMBIENT
uniform float u_ambient; // what a white surface reflects of light from everywhere, on average
#ifdef OCCLUSION_MAP
uniform sampler2D u_occlusionMap;
uniform float u_occlusionStrength;
#endif
#ifdef EMISSIVE
uniform vec3 u_emissive;
#ifdef EMISSIVE_MAP
uniform sampler2D u_emissiveMap;
#endif
#endif
#include "environment.glsl"
#endif
#ifdef SLICED
uniform float u_farthest;
varying float v_depth;
#endif

#include "facing.glsl"
#include "eye.glsl"
#include "tone_mapping.glsl"
#include "brdf.glsl"
#ifdef LIT
uniform vec3 u_lightColor; // what a white Lambert surface reflects of it at normal incidence
#include "light.glsl"
#endif
#ifdef LIGHT_LIST
#include "light_table.glsl"
#endif
#ifdef SOFT_TERMINATOR
#include "terminator.glsl"
#endif

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

#if defined(NORMAL_MAP) || defined(CLEARCOAT_NORMAL_MAP)
// The normal that a texture gives the fragment; `geometric` is the vertices' normal, of the front
// side. The texture's own y points down along v, its normals' y up (glTF 2.0, 3.9.3).
vec3 mappedNormal(vec3 geometric, vec3 texel, float scale, vec2 place) {
    vec3 turned = texel * 2.0 - 1.0;
    turned.xy *= scale;
#ifdef TANGENTS
    vec3 tangent = normalize(v_tangent.xyz);
    vec3 bitangent = cross(geometric, tangent) * (v_tangent.w < 0.0 ? -1.0 : 1.0);
#else
    vec3 alongX = dFdx(v_fromEye), alongY = dFdy(v_fromEye);
    vec2 uvX = dFdx(place), uvY = dFdy(place);
    float turn = uvX.x * uvY.y - uvY.x * uvX.y;
    vec3 tangent = (alongX * uvY.y - alongY * uvX.y) * sign(turn);
    tangent -= geometric * dot(geometric, tangent);
    vec3 upward = (alongX * uvY.x - alongY * uvX.x) * sign(turn); // against v
    float most = dot(tangent, tangent);
    if (!(most > 0.0)) return geometric;
    tangent *= inversesqrt(most);
    vec3 bitangent = cross(geometric, tangent);
    bitangent *= dot(bitangent, upward) < 0.0 ? -1.0 : 1.0;
#endif
    vec3 normal = tangent * turned.x + bitangent * turned.y + geometric * turned.z;
    float size = dot(normal, normal);
    return size > 0.0 ? normal * inversesqrt(size) : geometric;
}
#endif

float strongest(vec3 color) { return max(color.r, max(color.g, color.b)); }

vec4 baseColor() {
    vec4 base = u_baseColor;
#ifdef COLORED
    base *= vec4(linearFromSrgb(v_color.rgb), v_color.a);
#endif
#ifdef TEXTURED
    vec4 texel = texture2D(u_texture, v_texcoord);
    base *= vec4(linearFromSrgb(texel.rgb), texel.a);
#endif
    return base;
}

Surface surfaceOf(vec3 base) {
    Surface surface;
    surface.toEye = normalize(towardsEye());
    float size = dot(v_normal, v_normal);
    vec3 geometric = size > 0.0 ? v_normal * inversesqrt(size) : surface.toEye;
    surface.normal = geometric * facing();
#ifdef NORMAL_MAP
    surface.normal = facing() * mappedNormal(geometric, texture2D(u_normalMap, NORMAL_MAP_UV).xyz,
                                             u_normalScale, NORMAL_MAP_UV);
#endif
    float metallic = u_reflectance.x;
    surface.roughness = u_reflectance.y;
    vec3 specularColor = u_specularColor;
#ifdef GLOSSY
#ifdef REFLECTANCE_MAP
    vec4 gloss = texture2D(u_reflectanceMap, REFLECTANCE_MAP_UV);
    specularColor *= linearFromSrgb(gloss.rgb);
    surface.roughness = 1.0 - (1.0 - surface.roughness) * gloss.a;
#endif
    surface.reflectance = specularColor;
    surface.grazingReflectance = 1.0;
    surface.dielectric = vec2(strongest(specularColor), 1.0);
    surface.diffuse = base * (1.0 - surface.dielectric.x);
#else
#ifdef REFLECTANCE_MAP
    vec4 texel = texture2D(u_reflectanceMap, REFLECTANCE_MAP_UV);
    metallic *= texel.b;
    surface.roughness *= texel.g;
#endif
    float specular = u_reflectance.w;
#ifdef SPECULAR_MAP
    specular *= texture2D(u_specularMap, SPECULAR_MAP_UV).a;
#endif
#ifdef SPECULAR_COLOR_MAP
    specularColor *= linearFromSrgb(texture2D(u_specularColorMap, SPECULAR_COLOR_MAP_UV).rgb);
#endif
    vec3 dielectric = min(u_reflectance.z * specularColor, vec3(1.0)) * specular;
    surface.reflectance = mix(dielectric, base, metallic);
    surface.grazingReflectance = mix(specular, 1.0, metallic);
    surface.dielectric = vec2(strongest(dielectric), specular);
    surface.diffuse = base * (1.0 - metallic);
#endif
    surface.roughness = clamp(surface.roughness, 0.05, 1.0); // a perfect mirror wouldn't show a
                                                             // point light
#ifdef CLEARCOAT
    surface.coat = u_clearcoat.x;
    surface.coatRoughness = u_clearcoat.y;
    surface.coatNormal = geometric * facing();
#ifdef CLEARCOAT_MAP
    surface.coat *= texture2D(u_clearcoatMap, CLEARCOAT_MAP_UV).r;
#endif
#ifdef CLEARCOAT_ROUGHNESS_MAP
    surface.coatRoughness *= texture2D(u_clearcoatRoughnessMap, CLEARCOAT_ROUGHNESS_MAP_UV).g;
#endif
#ifdef CLEARCOAT_NORMAL_MAP
    surface.coatNormal =
        facing() * mappedNormal(geometric,
                                texture2D(u_clearcoatNormalMap, CLEARCOAT_NORMAL_MAP_UV).xyz,
                                u_clearcoat.z, CLEARCOAT_NORMAL_MAP_UV);
#endif
    surface.coatRoughness = clamp(surface.coatRoughness, 0.05, 1.0);
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
    float lit = 1.0;
#ifdef COARSE_MASK
    lit = litByCoarseMask(u_casts > 0.5); // first: derivatives need the neighbouring fragments
#endif
#ifdef PRIMITIVE_MAP
    findMapPoint();
#endif
#ifdef SLICED
    if (v_depth > u_farthest) discard;
#endif
    vec4 base = baseColor();
#ifdef ALPHA_TEST
    if (base.a < u_alphaCutoff) discard;
#endif
    Surface surface = surfaceOf(base.rgb);
    Seen seen = Seen(vec3(0.0), vec3(0.0));
#ifdef AMBIENT
    float occlusion = 1.0;
#ifdef OCCLUSION_MAP
    occlusion += u_occlusionStrength * (texture2D(u_occlusionMap, OCCLUSION_MAP_UV).r - 1.0);
#endif
    addAmbient(surface, occlusion, seen);
#ifdef EMISSIVE
    vec3 emission = u_emissive;
#ifdef EMISSIVE_MAP
    emission *= linearFromSrgb(texture2D(u_emissiveMap, EMISSIVE_MAP_UV).rgb);
#endif
#ifdef CLEARCOAT
    emission *= beneathCoat(surface);
#endif
    seen.reflected += emission;
#endif
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
#ifdef FALLOFF
    window /= max(dot(v_towardsLight, v_towardsLight), 1e-12);
#endif
#ifdef SOFT_TERMINATOR
    window *= lightAtTerminator(normalize(side), light);
#endif
    addLight(surface, light, u_lightColor * (window * lit), seen);
#endif
#ifdef LIGHT_LIST
#ifdef SOFT_TERMINATOR
    vec3 side = normalize(v_normal * facing());
#endif
    highp vec2 list = lightListHere();
    for (int i = 0; i < LIGHT_LIST; ++i) {
        if (float(i) >= list.y) break;
        vec3 light, color;
        float window = listedLight(list.x + float(i), light, color);
#ifdef SOFT_TERMINATOR
        window *= lightAtTerminator(side, light);
#endif
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
