// Where a warped map's texels are: see MapWarp. A lattice of MAP_WARPED cells along an edge, each of two
// triangles, has its nodes moved.
uniform mediump sampler2D u_warp;   // nodes: x and y, two bytes each
uniform highp vec4 u_warpInner;     // of the inner cells the low corner and one over their size
uniform highp vec4 u_warpOuter;     // cells per length below them, and above
uniform highp float u_mapShare;     // what of the texture's width is within the frame

struct WarpCell {
    vec2 corner;     // in the texture
    vec2 alongX, alongY; // what the whole of the cell adds, in the triangle that has the place
    vec2 place;      // within it, 0..1
    vec2 perLength;  // cells per length of the places
};

vec2 warpNode(vec2 index) {
    vec4 bytes = floor(texture2D(u_warp, (index + 0.5) / float(MAP_WARPED + 1)) * 255.0 + 0.5);
    vec2 at = (bytes.rb * 256.0 + bytes.ga) / 65535.0;
    return at * u_mapShare + 0.5 * (1.0 - u_mapShare);
}

WarpCell warpCell(vec2 at) {
    WarpCell found;
    vec2 aside = at - u_warpInner.xy;
    vec2 within = aside * u_warpInner.zw;
    vec2 above = aside - 1.0 / u_warpInner.zw;
    vec2 lattice = 1.0 + clamp(within, 0.0, 1.0) * float(MAP_WARPED - 2) + min(aside, 0.0) * u_warpOuter.xy +
                   max(above, 0.0) * u_warpOuter.zw;
    vec2 cell = clamp(floor(lattice), 0.0, float(MAP_WARPED - 1));
    found.place = lattice - cell;
    found.perLength = mix(u_warpInner.zw * float(MAP_WARPED - 2),
                          mix(u_warpOuter.zw, u_warpOuter.xy, step(cell, vec2(0.5))),
                          step(0.5 * float(MAP_WARPED) - 1.25, abs(cell - 0.5 * float(MAP_WARPED - 1))));
    found.corner = warpNode(cell);
    vec2 last = warpNode(cell + 1.0);
    if (found.place.x > found.place.y) {
        vec2 right = warpNode(cell + vec2(1.0, 0.0));
        found.alongX = right - found.corner;
        found.alongY = last - right;
    } else {
        vec2 up = warpNode(cell + vec2(0.0, 1.0));
        found.alongX = last - up;
        found.alongY = up - found.corner;
    }
    return found;
}

vec2 warped(vec2 at) {
    WarpCell cell = warpCell(at);
    return cell.corner + cell.place.x * cell.alongX + cell.place.y * cell.alongY;
}

// From a texel to its neighbours, in map space: what the warp there undoes.
void warpAxes(vec2 at, float texel, out vec3 axisS, out vec3 axisT) {
    WarpCell cell = warpCell(at);
    vec2 x = cell.alongX * cell.perLength.x, y = cell.alongY * cell.perLength.y;
    float area = x.x * y.y - x.y * y.x;
    float scale = texel / max(area, 1e-12);
    axisS = vec3(y.y * scale, -x.y * scale, 0.0);
    axisT = vec3(-y.x * scale, x.x * scale, 0.0);
}
