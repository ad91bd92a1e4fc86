// Whether a light reaches a fragment, by a mask of lower resolution. The four texels around it
// vote, each with its bilinear weight, but only those that show the fragment's own surface: this
// keeps light and shadow from leaking over outlines and into corners (joint bilateral upsampling:
// Kopf et al. 2007). More than half of the votes decide, so that edges stay hard.
#include "coarse_plane.glsl"

uniform mediump sampler2D u_coarseSurface; // see packPlane()
uniform mediump sampler2D u_coarseLit;     // alpha 1: lit
uniform vec2 u_coarseSize;                 // texels
uniform vec2 u_coarseTexel;                // a texel's size in fragments
uniform float u_coarseSlack; // how far a curved surface may leave its plane, in nearness; relative
                             // except with ORTHOGRAPHIC
uniform vec4 u_coarseLight;                // in the space of the planes

// Largest difference between two directions: about 30 degrees, which their four bits can resolve.
const float largestTurn = 0.25;

float litByCoarseMask(bool casts) {
    Plane own = planeHere();
    // Casters seen from the side that is turned away from the light are dark without asking the
    // mask.
    if (casts && dot(own.normal, u_coarseLight.xyz) > own.offset * u_coarseLight.w) return 0.0;
    vec2 ownDirection = direction(own.normal);
    vec2 at = (placeHere() * 0.5 + 0.5) * u_coarseSize - 0.5;
    vec2 first = floor(at);
    vec2 part = at - first;
    vec2 change = own.change * u_coarseTexel;
    float slack = u_coarseSlack;
#ifndef ORTHOGRAPHIC
    slack *= own.nearness;
#endif
    float tolerance = 0.1 * (abs(change.x) + abs(change.y)) + slack + 1.5 / largestInverse;
    float votes = 0.0;
    float lit = 0.0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            vec2 corner = vec2(float(i), float(j));
            vec2 place = (first + corner + 0.5) / u_coarseSize;
            vec3 there = unpackPlane(texture2D(u_coarseSurface, place));
            float apart =
                abs(there.x - own.nearness - dot(change, corner - part)) / tolerance;
            float turn = distance(there.yz, ownDirection) / largestTurn;
            float away = max(apart, turn);
            // If no texel shows the same surface, the nearest match decides.
            float weight = away <= 1.0 ? 1.0 : 1e-3 / (away * away);
            vec2 near = mix(1.0 - part, part, corner);
            weight *= near.x * near.y;
            votes += weight;
            lit += weight * texture2D(u_coarseLit, place).a;
        }
    return step(0.5 * votes, lit);
}
