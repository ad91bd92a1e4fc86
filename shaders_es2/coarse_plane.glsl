// The plane of the triangle at a fragment, and how coarse_surface.frag stores it for each texel of
// a coarse mask: three bytes of nearness, one of the direction. Along a plane nearness changes
// linearly over the picture, so two derivatives describe it fully.
//
// Space: the camera's, x right, y up, z the depth along the viewing direction, in units of the near
// plane's distance; with ORTHOGRAPHIC in scene units, z starting at the near plane.
#include "nearness.glsl"

uniform vec2 u_tangents; // half the picture's window, across and up
uniform vec2 u_middle;   // the window's middle
uniform vec2 u_focal;    // fragments per unit of the window
#ifdef ORTHOGRAPHIC
uniform float u_depthRange; // from the near plane to the far plane, scene units
#endif

struct Plane {
    float nearness; // 0..1
    vec2 change;    // of the nearness, from a fragment to the next
    vec3 normal;    // points p of the plane: dot(normal, p) = offset
    float offset;
};

// The fragment's place in normalised device coordinates.
vec2 placeHere() {
#ifdef ORTHOGRAPHIC
    return v_clip.xy;
#else
    return v_clip.xy / v_clip.z;
#endif
}

Plane planeHere() {
    Plane plane;
    plane.nearness = nearnessHere();
    plane.change = vec2(dFdx(plane.nearness), dFdy(plane.nearness));
    vec2 slope = plane.change * u_focal;
    vec2 window = placeHere() * u_tangents + u_middle;
    float rest = plane.nearness - dot(slope, window);
#ifdef ORTHOGRAPHIC
    plane.normal = vec3(slope * u_depthRange, 1.0);
    plane.offset = (1.0 - rest) * u_depthRange;
#else
    plane.normal = vec3(slope, rest);
    plane.offset = 1.0;
#endif
    return plane;
}

// The direction of a normal that points away from the eye, in a square of -1..1 (stereographic).
vec2 direction(vec3 normal) {
    return clamp(normal.xy / max(length(normal) + normal.z, 1e-30), -1.0, 1.0);
}

vec4 packPlane(Plane plane) {
    vec4 bytes = vec4(nearnessBytes(plane.nearness), 0.0);
    vec2 nibbles = floor(direction(plane.normal) * 7.5 + 8.0);
    bytes.a = min(nibbles.x, 15.0) * 16.0 + min(nibbles.y, 15.0);
    return bytes / 255.0;
}

// Nearness, then direction. An empty texel is 0.
vec3 unpackPlane(vec4 texel) {
    vec4 bytes = floor(texel * 255.0 + 0.5);
    float upper = floor(bytes.a / 16.0);
    return vec3(dot(bytes.rgb, vec3(65536.0, 256.0, 1.0)) / largestInverse,
                (vec2(upper, bytes.a - upper * 16.0) - 7.5) / 7.5);
}
