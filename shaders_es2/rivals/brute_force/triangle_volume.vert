// The shadow volume of one triangle A < B < C, whatever its neighbours (Sambeek 2007): its front
// cap, its three sides, its back cap, all counted with that triangle's one sign, so that it is
// closed whatever the sign (docs/method.md, C3).
//
// Each volume takes two draws: first caps and sides of multiplicity 1, then sides of multiplicity
// -1, whose stencil operations are swapped. So the side over an edge has the same vertices in the
// same order for either triangle, and neighbours' sides cancel in every pixel (C5).
//
// Vertices v: 0..2 the front cap; 3..8 the first triangles of up to two sides, 9..14 the second
// ones, which have no area for a directional light; 15..17 the back cap, likewise.
//
// Variants: INSTANCED as in sides.vert, else u_vertices gives the range that is drawn; also those
// of cap_corner.glsl.
#include "record_layout.glsl"
#include "rivals/published/multiplicity.glsl"
#include "cap_corner.glsl"

#ifdef INSTANCED
attribute vec2 a_corner; // x: v
#else
uniform vec2 u_vertices; // the first, and one past the last
#endif
attribute vec4 a_capA; // when not instanced: w = v
attribute vec4 a_capB;
attribute vec4 a_capC;

uniform vec4 u_light;         // in object space
uniform float u_multiplicity; // 1 or -1: the multiplicity of the sides that are drawn

void emitSide(float v, float facing) {
    bool second = v > 5.5;
    float corner = second ? v - 6.0 : v;
    bool further = corner > 2.5; // the second of the triangle's sides
    float of = further ? corner - 3.0 : corner;
    // AB and BC have the triangle's sign; the opposite vertex of AC is between its ends.
    bool two = facing == u_multiplicity;
    vec3 low = two && further ? a_capB.xyz : a_capA.xyz;
    vec3 high = two && !further ? a_capB.xyz : a_capC.xyz;
    float id = second ? of + 1.0 : 2.0 - of; // as in sides.vert
    vec3 end = id == 0.0 || id == 2.0 ? low : high;
    vec4 place = id > 1.5 ? toInfinity(end, u_light) : vec4(end, 1.0);
    bool drawn = facing != 0.0 && (two || !further);
    gl_Position = drawn ? rasterizable(u_clipFromObject, clipPosition(u_clipFromObject, place))
                        : vec4(0.0);
#ifdef ALPHA_TEST
    v_alphaLookup = vec3(0.0);
    v_isBack = 1.0; // solid
#endif
#ifdef NEAR_DISCARD
    v_clipZW = vec2(0.0, 1.0); // never discarded: only clipping cuts it
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
    if (v > 2.5 && v < 14.5)
        emitSide(v - 3.0, facing);
    else
        emitCap(v < 2.5 ? v : v - 12.0, facing, a_capA.xyz, a_capB.xyz, a_capC.xyz, u_light);
}
