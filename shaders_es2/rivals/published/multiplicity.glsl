// Signs and multiplicities: docs/method.md, Terms. Written in the common part of GLSL ES 1.00 and
// C++ with GLM, so that the tests run these very lines on the CPU.
//
// CONTACT: the light touches casters, and counts as lying in planes no farther away than u_reach
// (C47).
//
// One evaluation order everywhere: dot and cross products are spelled out, since the built-in ones
// may be summed in any order. MULTIPLICITY_THREE_EDGE and MULTIPLICITY_SINGLE_EDGE choose the older
// methods; without them the reference edge decides.

float orderedDot(vec3 x, vec3 y) { return x.x * y.x + x.y * y.y + x.z * y.z; }

vec3 orderedCross(vec3 x, vec3 y) {
    return vec3(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
}

// From p to the light; for a directional light (w = 0) its direction.
vec3 towardsLight(vec3 p, vec4 light) {
    return vec3(light.x - p.x * light.w, light.y - p.y * light.w, light.z - p.z * light.w);
}

#ifdef CONTACT
uniform float u_reach;
#endif

// The side of the light plane (the plane through the edge a-b and the light) on which p lies: -1, 0
// or 1. Equals the facing of the triangle (a, p, b).
float lightPlaneSide(vec3 a, vec3 b, vec3 p, vec4 light) {
    float side = orderedDot(orderedCross(b - a, towardsLight(a, light)), p - a);
#ifdef CONTACT
    vec3 normal = orderedCross(b - a, p - a);
    if (side * side <= u_reach * u_reach * orderedDot(normal, normal)) return 0.0;
#endif
    return sign(side);
}

// The sign of a triangle a < b < c: 1 if the light sees it counter-clockwise, -1 if clockwise, 0
// if the light lies in its plane.
float triangleSign(vec3 a, vec3 b, vec3 c, vec4 light) {
#if defined(MULTIPLICITY_THREE_EDGE)
    // Peciva 2013, 2.3: a triangle on which its three edges disagree casts nothing.
    float byAC = lightPlaneSide(a, c, b, light);
    float byAB = -lightPlaneSide(a, b, c, light);
    float byBC = -lightPlaneSide(b, c, a, light);
    return byAC == byAB && byAB == byBC ? byAC : 0.0;
#elif defined(MULTIPLICITY_SINGLE_EDGE)
    // Kim 2008 has no rule for caps: the first edge decides.
    return -lightPlaneSide(a, b, c, light);
#else
    // Milet 2020, Algorithm 8: the reference edge goes from the smallest to the largest vertex.
    return lightPlaneSide(a, c, b, light);
#endif
}

// Multiplicity that one opposite vertex adds to the edge a < b. opposite.w: ORDER_*.
float oppositeMultiplicity(vec3 a, vec3 b, vec4 opposite, vec4 light) {
    vec3 o = vec3(opposite.x, opposite.y, opposite.z);
#if defined(MULTIPLICITY_SINGLE_EDGE)
    // Kim 2008: every edge tests against its own light plane, which is why triangles come apart.
    float facing = -lightPlaneSide(a, b, o, light);
#else
    bool first = opposite.w == ORDER_OPPOSITE_FIRST;
    bool last = opposite.w == ORDER_OPPOSITE_LAST;
    vec3 low = first ? o : a;
    vec3 middle = first ? a : (last ? b : o);
    vec3 high = last ? o : b;
    float facing = triangleSign(low, middle, high, light) * (first || last ? 1.0 : -1.0);
#endif
    return opposite.w == ORDER_ABSENT ? 0.0 : facing;
}
