// Lights without a shadow and each tile's list of them (LightTable in src/render/frame), in one
// texture: for each tile, where its list begins and how long it is; then the lists, four entries a
// texel; then the lights, four texels each. LIGHT_LIST: length of the longest list, or more.
// Include eye.glsl first.
uniform highp sampler2D u_lightTable; // lowp, the default, may round the values
uniform highp vec3 u_lightTableSize;  // (columns, 1 / columns, 1 / rows)
uniform highp vec4 u_lightTiles;      // tiles in a row, 1 / a tile's pixels, where lists begin,
                                      // where lights begin

// Texels are numbered row by row. `columns` is a power of 2, so none of this is rounded.
highp vec4 lightTexel(highp float index) {
    highp float row = floor(index * u_lightTableSize.y);
    highp float column = index - row * u_lightTableSize.x;
    return texture2D(u_lightTable, vec2((column + 0.5) * u_lightTableSize.y,
                                        (row + 0.5) * u_lightTableSize.z));
}

// The fragment's list: its first entry and its length in lights.
highp vec2 lightListHere() {
    highp vec2 tile = floor(gl_FragCoord.xy * u_lightTiles.y);
    return lightTexel(tile.y * u_lightTiles.x + tile.x).xy;
}

// A spot's share of its light there, as in light_window.glsl. `spot`: its axis, and 1 / (1 -
// cos(outer)).
float spotWindow(highp vec3 fromLight, highp vec4 spot, float scale) {
    highp vec3 place = fromLight / max(max(abs(fromLight.x), abs(fromLight.y)),
                                       max(abs(fromLight.z), 1e-30));
    highp vec3 across = cross(spot.xyz, place);
    float aside = dot(across, across);
    float along = dot(spot.xyz, place);
    float squared = aside + along * along;
    float cosine = along * inversesqrt(squared);
    float away = aside / (squared * (1.0 + max(cosine, 0.0))) * spot.w;
    float share = cosine > 0.0 ? clamp((1.0 - away) * scale, 0.0, 1.0) : 0.0;
    return share * share;
}

// An entry's light as the fragment receives it: its window, its direction and its colour, in which
// 1 is what a white Lambert surface reflects at normal incidence.
float listedLight(highp float entry, out vec3 light, out vec3 color) {
    highp float four = floor(0.25 * entry);
    highp vec4 entries = lightTexel(u_lightTiles.z + four);
    highp float place = entry - 4.0 * four;
    highp float at = place < 1.5 ? (place < 0.5 ? entries.x : entries.y)
                                 : (place < 2.5 ? entries.z : entries.w);
    highp float texel = u_lightTiles.w + 4.0 * at;
    highp vec4 where = lightTexel(texel);    // w: 0 directional, 1 point, 2 point with falloff; 3,
                                             // 4: spots likewise
    highp vec4 shining = lightTexel(texel + 1.0); // colour, 1 / range or 0
    light = where.xyz;
    color = shining.rgb;
    if (where.w < 0.5) return 1.0;
    highp vec3 towards = where.xyz - v_fromEye;
    light = normalize(towards / max(max(abs(towards.x), abs(towards.y)), max(abs(towards.z), 1e-30)));
    highp vec3 reached = towards * shining.w;
    float share = dot(reached, reached);
    float window = max(1.0 - share * share, 0.0);
    if (where.w > 2.5) {
        window *= spotWindow(-towards, lightTexel(texel + 2.0), lightTexel(texel + 3.0).x);
        if (where.w > 3.5) color /= max(dot(towards, towards), 1e-12);
    } else if (where.w > 1.5) {
        color /= max(dot(towards, towards), 1e-12);
    }
    return window;
}
