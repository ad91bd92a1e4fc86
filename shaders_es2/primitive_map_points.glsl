// How many places of a light with an extent reach a point, by the light's primitive map
// (docs/method.md, C42; PrimitiveMap in src/shadow/primitive_map). Include it after
// primitive_map_lookup.glsl, which finds the point's texel. A record holds a triangle's corners a,
// b, c in order, so that both triangles of an edge compute the same for it.
//   PRIMITIVE_MAP_ONE_TABLE  the places are in the map's table: PackedPrimitiveMap in src/scene
#ifdef PRIMITIVE_MAP_ONE_TABLE
uniform highp vec2 u_primitivePlaces; // first texel of the places, number of sixteens of them
highp float sixteenAt;                // first texel of the sixteen places that are tested
highp float placesW;
#define PRIMITIVE_PLACES_X(k) primitiveTexel(sixteenAt + float(k))
#define PRIMITIVE_PLACES_Y(k) primitiveTexel(sixteenAt + float(k) + 4.0)
#define PRIMITIVE_PLACES_Z(k) primitiveTexel(sixteenAt + float(k) + 8.0)
#define PRIMITIVE_PLACES_COUNTED(k) primitiveTexel(sixteenAt + float(k) + 12.0)
#define PRIMITIVE_PLACES_W placesW
#define PRIMITIVE_TOWARDS_EYE(a) primitiveTowardsEye
#else
#include "primitive_map_places.glsl"
#endif

// How far off a triangle's plane rounding may have put a point of it, in map space.
highp float pointError;

// For the triangle being tested: the planes through the point and each edge, the triangle's normal,
// and the side of it that the point is on.
highp vec3 edgeAB;
highp vec3 edgeBC;
highp vec3 edgeAC;
highp vec3 triangleNormal;
highp float abovePlane;
highp float hand;

// For each of four places, 1 if the triangle doesn't block it, else 0.
highp vec4 notBlocked(highp vec4 x, highp vec4 y, highp vec4 z) {
    highp vec4 first = edgeAB.x * x + edgeAB.y * y + edgeAB.z * z;
    highp vec4 second = edgeBC.x * x + edgeBC.y * y + edgeBC.z * z;
    highp vec4 third = edgeAC.x * x + edgeAC.y * y + edgeAC.z * z;
    highp vec4 across = hand * (triangleNormal.x * x + triangleNormal.y * y +
                                triangleNormal.z * z + vec4(PRIMITIVE_PLACES_W * abovePlane));
    highp vec4 zero = vec4(0.0);
    highp vec4 within = max(step(zero, first) * step(zero, second) * step(third, zero),
                            step(first, zero) * step(second, zero) * step(zero, third));
    // A place on the other side of the plane has across < 0.
    return vec4(1.0) - within * (vec4(1.0) - step(zero, across));
}

#if defined(MASK) || defined(PRIMITIVE_MAP_ONE_TABLE)
// For each of four places, 1 unless it only grazes the triangle, else 0: the sine of the angle to
// the triangle's plane is above LightContact::grazingSine (docs/method.md, C47).
highp vec4 notGrazing(highp vec4 x, highp vec4 y, highp vec4 z) {
    highp vec4 across = triangleNormal.x * x + triangleNormal.y * y + triangleNormal.z * z;
    return step(1e-5 * length(triangleNormal) * sqrt(x * x + y * y + z * z), abs(across));
}
#endif

highp float sumOf(highp vec4 four) { return four.x + four.y + four.z + four.w; }

// Number of places, of 16, that the triangles in the texel's list leave. Call it after
// findPrimitiveTexel(), for a list that isn't empty. `casts`: see primitiveListIsEmpty().
highp float placesLeft(highp vec3 point, bool casts) {
    highp vec4 seen[4];
    highp vec4 towardsX[4];
    highp vec4 towardsY[4];
    highp vec4 towardsZ[4];
    for (int k = 0; k < 4; ++k) {
        seen[k] = PRIMITIVE_PLACES_COUNTED(k);
        towardsX[k] = PRIMITIVE_PLACES_X(k) - vec4(PRIMITIVE_PLACES_W * point.x);
        towardsY[k] = PRIMITIVE_PLACES_Y(k) - vec4(PRIMITIVE_PLACES_W * point.y);
        towardsZ[k] = PRIMITIVE_PLACES_Z(k) - vec4(PRIMITIVE_PLACES_W * point.z);
    }
    highp float list = floor(primitiveHeader.w);
    for (int i = 0; i < PRIMITIVE_MAP_LONGEST; ++i) {
        highp vec4 entry = primitiveEntry(list + float(i));
        highp float record = 3.0 * floor(entry.x);
        highp vec3 a = primitiveRecord(record).xyz;
        highp vec3 b = primitiveRecord(record + 1.0).xyz;
        highp vec3 c = primitiveRecord(record + 2.0).xyz;
        edgeAB = cross(a - point, b - a);
        edgeBC = cross(b - point, c - b);
        edgeAC = cross(a - point, c - a);
        triangleNormal = cross(b - a, c - a);
        abovePlane = dot(triangleNormal, point - a);
        highp vec3 terms = abs(triangleNormal);
        // A point on the triangle is on the side that it is seen from.
        bool isOn = abs(abovePlane) <= pointError * (terms.x + terms.y + terms.z);
        highp float side = isOn ? dot(triangleNormal, PRIMITIVE_TOWARDS_EYE(a)) : abovePlane;
#if defined(MASK) || defined(PRIMITIVE_MAP_ONE_TABLE)
        if (isOn)
            for (int k = 0; k < 4; ++k)
                seen[k] *= notGrazing(towardsX[k], towardsY[k], towardsZ[k]);
#endif
        hand = side > 0.0 ? 1.0 : (side < 0.0 ? -1.0 : 0.0);
        // Not a loop: some GLs end loops after a number of turns that includes those of inner
        // loops.
        seen[0] *= notBlocked(towardsX[0], towardsY[0], towardsZ[0]);
        seen[1] *= notBlocked(towardsX[1], towardsY[1], towardsZ[1]);
        seen[2] *= notBlocked(towardsX[2], towardsY[2], towardsZ[2]);
        seen[3] *= notBlocked(towardsX[3], towardsY[3], towardsZ[3]);
        if (sumOf(seen[0] + seen[1] + seen[2] + seen[3]) == 0.0) return 0.0;
        if (primitiveDepth <= entry.w) break; // all further ones are deeper
        if (casts && entry.x > floor(entry.x)) break; // or only points that don't cast test them
    }
    return sumOf(seen[0] + seen[1] + seen[2] + seen[3]);
}
