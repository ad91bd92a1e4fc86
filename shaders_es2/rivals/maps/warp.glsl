// Places texels of a warped map (MapWarp): the nodes of a lattice of MAP_WARPED by MAP_WARPED
// cells, each of two triangles, are moved.
uniform mediump sampler2D u_warp; // nodes: x and y, two bytes each
uniform vec4 u_warpInner; // low corner of the inner cells, and one over their size
uniform vec4 u_warpOuter; // cells per length below the inner cells, and above
uniform float u_mapShare; // share of the texture's width within the frame

// The piece of the warp in use, as if it continued alike. So filters' taps are whole texels apart,
// and one lookup of nodes serves them all.
vec2 warpFrom;     // a place in the map
vec2 warpTo;       // that place in the texture
vec2 warpX, warpY; // change of texture coordinates per length

vec2 warpNode(vec2 index) {
    vec4 bytes = floor(texture2D(u_warp, (index + 0.5) / float(MAP_WARPED + 1)) * 255.0 + 0.5);
    vec2 at = (bytes.rb * 256.0 + bytes.ga) / 65535.0;
    return at * u_mapShare + 0.5 * (1.0 - u_mapShare);
}

void useWarp(vec2 at) {
    vec2 aside = at - u_warpInner.xy;
    vec2 above = aside - 1.0 / u_warpInner.zw;
    vec2 lattice = 1.0 + clamp(aside * u_warpInner.zw, 0.0, 1.0) * float(MAP_WARPED - 2) +
                   min(aside, 0.0) * u_warpOuter.xy + max(above, 0.0) * u_warpOuter.zw;
    vec2 cell = clamp(floor(lattice), 0.0, float(MAP_WARPED - 1));
    vec2 within = lattice - cell;
    vec2 first = warpNode(cell), last = warpNode(cell + 1.0);
    bool lower = within.x > within.y;
    vec2 other = warpNode(cell + (lower ? vec2(1.0, 0.0) : vec2(0.0, 1.0)));
    vec2 alongX = lower ? other - first : last - other, alongY = lower ? last - other : other - first;
    warpFrom = at;
    warpTo = first + within.x * alongX + within.y * alongY;
    // Cells per length; outermost cells have their own.
    vec2 outermost = step(0.5 * float(MAP_WARPED) - 1.25, abs(cell - 0.5 * float(MAP_WARPED - 1)));
    vec2 perLength = mix(u_warpInner.zw * float(MAP_WARPED - 2),
                         mix(u_warpOuter.zw, u_warpOuter.xy, step(cell, vec2(0.5))), outermost);
    warpX = alongX * perLength.x;
    warpY = alongY * perLength.y;
}

vec2 warped(vec2 at) {
    vec2 aside = at - warpFrom;
    return warpTo + aside.x * warpX + aside.y * warpY;
}

// From a texel to its neighbours, in map space: the inverse of the warp there.
void warpAxes(float texel, out vec3 axisS, out vec3 axisT) {
    float scale = texel / max(warpX.x * warpY.y - warpX.y * warpY.x, 1e-12);
    axisS = vec3(warpY.y * scale, -warpX.y * scale, 0.0);
    axisT = vec3(-warpY.x * scale, warpX.x * scale, 0.0);
}
