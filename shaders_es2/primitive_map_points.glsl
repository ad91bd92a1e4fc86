// How many of a light's places reach a point, by the primitive map of a light with an extent
// (docs/method.md, C42; PrimitiveMap in src/shadow/primitive_map): after primitive_map_lookup.glsl,
// which finds the point's texel. A record holds a triangle's corners a, b, c, first ones first, so
// that the two triangles of an edge compute the same of it.
uniform highp vec4 u_placesX[4]; // of 16 places, in map space
uniform highp vec4 u_placesY[4];
uniform highp vec4 u_placesZ[4];
uniform highp float u_placesW; // of all of them; 0: they are directions
uniform highp vec4 u_placesCounted[4]; // 1, or 0: there is none
uniform highp vec4 u_mapEye;           // where it is seen from, in map space, homogeneous

// How far from a triangle's plane, in map space, rounding may have put a point of it.
highp float pointError;

highp float sumOf(highp vec4 four) { return four.x + four.y + four.z + four.w; }

// Of 16. `casts`: see primitiveListIsEmpty().
highp float placesSeen(highp vec3 point, bool casts) {
    highp vec4 seen[4];
    highp vec4 towardsX[4];
    highp vec4 towardsY[4];
    highp vec4 towardsZ[4];
    highp float all = 0.0;
    for (int k = 0; k < 4; ++k) {
        seen[k] = u_placesCounted[k];
        towardsX[k] = u_placesX[k] - vec4(u_placesW * point.x);
        towardsY[k] = u_placesY[k] - vec4(u_placesW * point.y);
        towardsZ[k] = u_placesZ[k] - vec4(u_placesW * point.z);
        all += sumOf(seen[k]);
    }
    if (!findPrimitiveTexel(point)) return all;
    if (primitiveDepth - pointError > primitiveHeader.x) return 0.0;
    if (primitiveListIsEmpty(casts)) return all;
    highp float list = floor(primitiveHeader.w);
    for (int i = 0; i < PRIMITIVE_MAP_LONGEST; ++i) {
        highp vec4 entry =
            primitiveTexel(u_primitiveEntries, u_primitiveEntriesSize, list + float(i));
        highp float record = 3.0 * floor(entry.x);
        highp vec3 a = primitiveTexel(u_primitiveRecords, u_primitiveRecordsSize, record).xyz;
        highp vec3 b = primitiveTexel(u_primitiveRecords, u_primitiveRecordsSize, record + 1.0).xyz;
        highp vec3 c = primitiveTexel(u_primitiveRecords, u_primitiveRecordsSize, record + 2.0).xyz;
        highp vec3 ab = cross(a - point, b - a);
        highp vec3 bc = cross(b - point, c - b);
        highp vec3 ac = cross(a - point, c - a);
        highp vec3 normal = cross(b - a, c - a);
        highp float above = dot(normal, point - a);
        highp vec3 terms = abs(normal);
        // What lies on the triangle is where it is seen from.
        highp float side = abs(above) > pointError * (terms.x + terms.y + terms.z)
                               ? above
                               : dot(normal, u_mapEye.xyz - u_mapEye.w * a);
        highp float hand = side > 0.0 ? 1.0 : (side < 0.0 ? -1.0 : 0.0);
        highp float left = 0.0;
        for (int k = 0; k < 4; ++k) {
            highp vec4 x = towardsX[k], y = towardsY[k], z = towardsZ[k];
            highp vec4 first = ab.x * x + ab.y * y + ab.z * z;
            highp vec4 second = bc.x * x + bc.y * y + bc.z * z;
            highp vec4 third = ac.x * x + ac.y * y + ac.z * z;
            highp vec4 across =
                hand * (normal.x * x + normal.y * y + normal.z * z + vec4(u_placesW * above));
            highp vec4 zero = vec4(0.0);
            highp vec4 within = max(step(zero, first) * step(zero, second) * step(third, zero),
                                    step(first, zero) * step(second, zero) * step(zero, third));
            // On the other side of the plane: across < 0.
            seen[k] *= vec4(1.0) - within * (vec4(1.0) - step(zero, across));
            left += sumOf(seen[k]);
        }
        if (left == 0.0) return 0.0;
        if (primitiveDepth <= entry.w) break; // all further ones are deeper
        if (casts && entry.x > floor(entry.x)) break; // or are asked by others alone
    }
    return sumOf(seen[0]) + sumOf(seen[1]) + sumOf(seen[2]) + sumOf(seen[3]);
}
