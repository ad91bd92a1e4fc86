// The shadow volume of one triangle A < B < C, no matter what is next to it (Sambeek 2007): its
// front cap, its three sides, its back cap, all turned by the one sign of that triangle, so that it is
// closed whatever the sign is (docs/method.md, C3).
//
// Vertices v: 0..2 the front cap; 3..11 the first triangle of the sides over AB, BC and AC, 12..20
// the second, which has no area where the light is a direction; 21..23 the back cap, likewise.
//
// Variants: INSTANCED as in sides.vert, else u_vertices says which are drawn; those of
// cap_corner.glsl.
#include "record_layout.glsl"
#include "published/multiplicity.glsl"
#include "cap_corner.glsl"

#ifdef INSTANCED
attribute vec2 a_corner; // x: v
#else
uniform vec2 u_vertices; // the first, and that after the last
#endif
attribute vec4 a_capA; // not instanced: w = v
attribute vec4 a_capB;
attribute vec4 a_capC;

uniform vec4 u_light; // in object space

// Vertex id of the side over low < high, 0..5, as in sides.vert: neighbours' sides over one edge have
// one diagonal, so that they cover the same pixels.
vec4 sideCorner(float id, vec3 low, vec3 high) {
    vec3 end = id == 0.0 || id == 2.0 ? low : high;
    return id > 1.5 ? toInfinity(end, u_light) : vec4(end, 1.0);
}

void emitSide(float v, float facing) {
    bool second = v > 8.5;
    float corner = second ? v - 9.0 : v;
    bool ab = corner < 2.5, bc = !ab && corner < 5.5;
    float of = corner - (ab ? 0.0 : bc ? 3.0 : 6.0);
    // The opposite vertex of AC is between its ends.
    float multiplicity = ab || bc ? facing : -facing;
    // The other winding swaps the first two vertices: a rasteriser that turns triangles so, and keeps
    // the last, reckons the same depths of both, and what touches a surface at the edge cancels, if
    // nothing of it is clipped.
    if (multiplicity < 0.0) of = of > 1.5 ? of : 1.0 - of;
    float id = second ? of + 1.0 : 2.0 - of;
    vec4 place = sideCorner(id, bc ? a_capB.xyz : a_capA.xyz, ab ? a_capB.xyz : a_capC.xyz);
    gl_Position = facing != 0.0 ? rasterizable(u_clipFromObject, clipPosition(u_clipFromObject, place))
                                : vec4(0.0);
#ifdef ALPHA_TEST
    v_alphaLookup = vec3(0.0);
    v_isBack = 1.0; // solid
#endif
#ifdef NEAR_DISCARD
    v_clipZW = vec2(0.0, 1.0); // what clips it is clipping alone
#endif
}

void main() {
    float facing = triangleSign(a_capA.xyz, a_capB.xyz, a_capC.xyz, u_light);
#ifdef INSTANCED
    float v = a_corner.x;
#else
    float v = a_capA.w;
    if (v < u_vertices.x || v >= u_vertices.y) facing = 0.0;
#endif
    if (v > 2.5 && v < 20.5)
        emitSide(v - 3.0, facing);
    else
        emitCap(v < 2.5 ? v : v - 18.0, facing, a_capA.xyz, a_capB.xyz, a_capC.xyz, u_light);
}
