// Sides of the shadow volumes, from records of one or two planes
// (preprocess/volumes/plane_pair_data.hpp).
//
// Variants: PAIR, two planes, else one; DIRECTIONAL, volumes end at infinity, where all points
// coincide, so that a side is the triangle of A, B and the pushed A; CAP, in place of the side the
// triangle between its edge and u_apex, of the front cap or the back cap
// (shadow/plan/draw_list.hpp); PROBE and DEGENERATE as in sides.vert.
#include "plane_side.glsl"
#include "extrusion.glsl"

attribute float a_corner; // 0: A, 1: B, 2 and 3: A and B pushed away from the light
attribute vec3 a_edgeA;
attribute vec3 a_edgeB;
attribute vec4 a_plane0;
#ifdef PAIR
attribute vec4 a_plane1;
#endif

uniform vec4 u_light;   // in object space
uniform float u_reach;  // see planeSide()
uniform vec2 u_counted; // see countedSide()
uniform float u_times;  // 1 or 2: draws only the sides that count this many times
uniform vec4 u_end;     // where volumes end, see pushedTo()
uniform mat4 u_clipFromObject;
#ifdef CAP
uniform vec3 u_apex;
uniform float u_back; // 1: the back cap, at the pushed edge; 0: the front cap
#endif
#ifdef DEGENERATE
uniform float u_degenerate;
#endif

invariant gl_Position;

float recordMultiplicity() {
    float m = countedSide(a_plane0, u_light, u_reach, u_counted);
#ifdef PAIR
    m -= countedSide(a_plane1, u_light, u_reach, u_counted);
#endif
    return m;
}

#ifdef PROBE
#include "probe.glsl"
#endif

void main() {
    float multiplicity = recordMultiplicity();
#ifdef PROBE
    emitProbe(multiplicity);
#else
    float corner = a_corner;
    bool turned = multiplicity < 0.0;
#ifdef CAP
    // Drawn as (2, 1, 0): the apex and the edge, which runs the other way around in the back cap.
    bool back = u_back > 0.5;
    bool isA = (corner > 0.5) == (turned == back);
    vec3 end = corner > 1.5 ? u_apex : (isA ? a_edgeA : a_edgeB);
    bool pushed = back;
#else
    // Drawn as (2, 1, 0), (1, 2, 3). Swapping 0 and 3 turns both triangles over and keeps their
    // diagonal; in the one triangle of a directional light, swapping 0 and 1 does.
#ifdef DIRECTIONAL
    if (turned && corner < 1.5) corner = 1.0 - corner;
#else
    if (turned && (corner < 0.5 || corner > 2.5)) corner = 3.0 - corner;
#endif
    vec3 end = corner == 0.0 || corner == 2.0 ? a_edgeA : a_edgeB;
    bool pushed = corner > 1.5;
#endif
    vec4 p = pushed ? pushedTo(u_end, end, u_light) : vec4(end, 1.0);
    vec4 clip = rasterizable(u_clipFromObject, clipPosition(u_clipFromObject, p));
#ifdef CAP
    if (!back) clip = movedToInfinity(clip);
#endif
    // An unused vertex makes its triangle a point, which covers no pixel.
    gl_Position = abs(multiplicity) == u_times ? clip : vec4(0.0);
#ifdef DEGENERATE
    gl_Position *= u_degenerate;
#endif
#endif
}
