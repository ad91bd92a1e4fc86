// A material's values at the fragment: its factors times its texture maps. Bits of MAPS, in the order
// of TextureSlot, say which maps the material has; MAP_SETS lists in the same order which set of
// texture coordinates each takes. TEXCOORDS: see surface.vert. TANGENTS: the vertices have tangents;
// without them normal maps take derivatives. GLOSSY, CLEARCOAT: see material.frag. Include
// tone_mapping.glsl and eye.glsl first.
uniform vec4 u_reflectance; // metallic, roughness, reflectance of dielectrics, specular
uniform vec3 u_specularColor;
uniform vec3 u_emissive;
#if (TEXCOORDS & 1) != 0
varying vec2 v_texcoord;
#endif
#if (TEXCOORDS & 2) != 0
varying vec2 v_texcoord1;
#endif
#if (TEXCOORDS & 4) != 0
varying vec4 v_texcoord23;
#endif

struct MapSets {
    int baseColor, reflectance, normal, occlusion, emissive, specular, specularColor, clearcoat,
        clearcoatRoughness, clearcoatNormal;
};
const MapSets sets = MapSets(MAP_SETS);

// The fragment's texture coordinates of a set.
vec2 coordinates(int set) {
#if (TEXCOORDS & 2) != 0
    if (set == 1) return v_texcoord1;
#endif
#if (TEXCOORDS & 4) != 0
    if (set == 2) return v_texcoord23.xy;
    if (set == 3) return v_texcoord23.zw;
#endif
#if (TEXCOORDS & 1) != 0
    return v_texcoord;
#else
    return vec2(0.0);
#endif
}

#if (MAPS & 1) != 0
uniform sampler2D u_texture;
vec4 baseTexel() {
    vec4 texel = texture2D(u_texture, coordinates(sets.baseColor));
    return vec4(linearFromSrgb(texel.rgb), texel.a);
}
#else
vec4 baseTexel() { return vec4(1.0); }
#endif

struct Reflectance {
    float metallic;
    float roughness;
    float specular;
    vec3 specularColor;
};

#if (MAPS & 2) != 0
uniform sampler2D u_reflectanceMap;
#endif
#if (MAPS & 32) != 0
uniform sampler2D u_specularMap;
#endif
#if (MAPS & 64) != 0
uniform sampler2D u_specularColorMap;
#endif
Reflectance reflectanceHere() {
    Reflectance here =
        Reflectance(u_reflectance.x, u_reflectance.y, u_reflectance.w, u_specularColor);
#if (MAPS & 2) != 0
    vec4 texel = texture2D(u_reflectanceMap, coordinates(sets.reflectance));
#ifdef GLOSSY
    here.specularColor *= linearFromSrgb(texel.rgb);
    here.roughness = 1.0 - (1.0 - here.roughness) * texel.a;
#else
    here.metallic *= texel.b;
    here.roughness *= texel.g;
#endif
#endif
#ifndef GLOSSY
#if (MAPS & 32) != 0
    here.specular *= texture2D(u_specularMap, coordinates(sets.specular)).a;
#endif
#if (MAPS & 64) != 0
    here.specularColor *=
        linearFromSrgb(texture2D(u_specularColorMap, coordinates(sets.specularColor)).rgb);
#endif
#endif
    return here;
}

#if (MAPS & 516) != 0
#ifdef TANGENTS
varying vec4 v_tangent;
#endif
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

// The surface's normal; `geometric` is the vertices', and both are of the front side.
#if (MAPS & 4) != 0
uniform sampler2D u_normalMap;
uniform float u_normalScale;
vec3 normalHere(vec3 geometric) {
    vec2 place = coordinates(sets.normal);
    return mappedNormal(geometric, texture2D(u_normalMap, place).xyz, u_normalScale, place);
}
#else
vec3 normalHere(vec3 geometric) { return geometric; }
#endif

// The share of light from everywhere that arrives.
#if (MAPS & 8) != 0
uniform sampler2D u_occlusionMap;
uniform float u_occlusionStrength;
float occlusionHere() {
    vec2 place = coordinates(sets.occlusion);
    return 1.0 + u_occlusionStrength * (texture2D(u_occlusionMap, place).r - 1.0);
}
#else
float occlusionHere() { return 1.0; }
#endif

#if (MAPS & 16) != 0
uniform sampler2D u_emissiveMap;
vec3 emissionHere() {
    return u_emissive *
           linearFromSrgb(texture2D(u_emissiveMap, coordinates(sets.emissive)).rgb);
}
#else
vec3 emissionHere() { return u_emissive; }
#endif

#ifdef CLEARCOAT
uniform vec3 u_clearcoat; // amount, roughness, scale of its normals
#if (MAPS & 128) != 0
uniform sampler2D u_clearcoatMap;
float coatHere() {
    return u_clearcoat.x * texture2D(u_clearcoatMap, coordinates(sets.clearcoat)).r;
}
#else
float coatHere() { return u_clearcoat.x; }
#endif

#if (MAPS & 256) != 0
uniform sampler2D u_clearcoatRoughnessMap;
float coatRoughnessHere() {
    vec2 place = coordinates(sets.clearcoatRoughness);
    return u_clearcoat.y * texture2D(u_clearcoatRoughnessMap, place).g;
}
#else
float coatRoughnessHere() { return u_clearcoat.y; }
#endif

#if (MAPS & 512) != 0
uniform sampler2D u_clearcoatNormalMap;
vec3 coatNormalHere(vec3 geometric) {
    vec2 place = coordinates(sets.clearcoatNormal);
    return mappedNormal(geometric, texture2D(u_clearcoatNormalMap, place).xyz, u_clearcoat.z,
                        place);
}
#else
vec3 coatNormalHere(vec3 geometric) { return geometric; }
#endif
#endif
