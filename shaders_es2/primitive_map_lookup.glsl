// Whether a light reaches a point, by its primitive map (docs/method.md, C34; PrimitiveMap in
// src/shadow/primitive_map). For any fragment shader: bind the three textures, give the point in
// map space, and define
//   PRIMITIVE_MAP_DIRECTIONAL  for a directional light, or PRIMITIVE_MAP_TILES for a point light of
//                              six tiles; neither: one of one tile
//   PRIMITIVE_MAP_SPLITS       how often texels are divided, one in another
//   PRIMITIVE_MAP_LONGEST      entries of the longest list, or more
uniform highp sampler2D u_primitiveHeader; // lowp, the default, may round what is looked up
uniform highp sampler2D u_primitiveEntries;
uniform highp sampler2D u_primitiveRecords;
uniform highp vec3 u_primitiveHeaderSize; // (columns, 1 / columns, 1 / rows); so the next two
uniform highp vec3 u_primitiveEntriesSize;
uniform highp vec3 u_primitiveRecordsSize;
uniform highp float u_primitiveSize; // texels along a tile's edge

// Texels are counted through the rows. `columns` is a power of 2, so none of this is rounded.
highp vec4 primitiveTexel(highp sampler2D table, highp vec3 size, highp float index) {
    highp float row = floor(index * size.y);
    highp float column = index - row * size.x;
    return texture2D(table, vec2((column + 0.5) * size.y, (row + 0.5) * size.z));
}

// Whether the triangle lies between the light and the point; `ray` is (x, y, 1) of a directional
// light, else the point.
bool primitiveBlocks(highp float record, highp vec3 ray, highp vec3 point) {
    highp vec4 a = primitiveTexel(u_primitiveRecords, u_primitiveRecordsSize, 3.0 * record);
    highp vec4 b = primitiveTexel(u_primitiveRecords, u_primitiveRecordsSize, 3.0 * record + 1.0);
    highp vec4 c = primitiveTexel(u_primitiveRecords, u_primitiveRecordsSize, 3.0 * record + 2.0);
    highp float behind = a.w * ray.x + b.w * ray.y + c.w * ray.z;
    // Both neighbours compute the same products, but for their sign.
    return a.x * ray.x + a.y * ray.y + a.z * ray.z >= 0.0 &&
           b.x * ray.x + b.y * ray.y + b.z * ray.z >= 0.0 &&
           c.x * ray.x + c.y * ray.y + c.z * ray.z >= 0.0 &&
#ifdef PRIMITIVE_MAP_DIRECTIONAL
           point.z > behind;
#else
           behind > 1.0;
#endif
}

// What findPrimitiveTexel() finds: the point's ray, its depth, and the texel's header.
highp vec3 primitiveRay;
highp float primitiveDepth;
highp vec4 primitiveHeader;

// Finds the texel that holds the point; false: it is past all casters.
bool findPrimitiveTexel(highp vec3 point) {
    highp float tile = 0.0;
    highp vec2 at = vec2(point.x, point.y);
    primitiveDepth = point.z;
#ifdef PRIMITIVE_MAP_DIRECTIONAL
    primitiveRay = vec3(point.x, point.y, 1.0);
#else
    primitiveRay = point;
#ifdef PRIMITIVE_MAP_TILES
    highp vec3 size = abs(point);
    if (size.x >= size.y && size.x >= size.z) {
        at = vec2(point.y, point.z);
        primitiveDepth = size.x;
        tile = point.x > 0.0 ? 0.0 : 1.0;
    } else if (size.y >= size.z) {
        at = vec2(point.z, point.x);
        primitiveDepth = size.y;
        tile = point.y > 0.0 ? 2.0 : 3.0;
    } else {
        primitiveDepth = size.z;
        tile = point.z > 0.0 ? 4.0 : 5.0;
    }
#endif
    if (primitiveDepth <= 0.0) return false;
    at = at / primitiveDepth;
#endif
    if (max(abs(at.x), abs(at.y)) > 1.0) return false;
    highp float halfSize = 0.5 * u_primitiveSize;
    at = at * halfSize + vec2(halfSize);
    highp vec2 cell = clamp(floor(at), vec2(0.0), vec2(u_primitiveSize - 1.0));
    primitiveHeader = primitiveTexel(u_primitiveHeader, u_primitiveHeaderSize,
                                     (tile * u_primitiveSize + cell.y) * u_primitiveSize + cell.x);
#if PRIMITIVE_MAP_SPLITS > 0
    for (int split = 0; split < PRIMITIVE_MAP_SPLITS; ++split) {
        if (primitiveHeader.w >= 0.0) break;
        at = (at - cell) * vec2(4.0);
        cell = clamp(floor(at), vec2(0.0), vec2(3.0));
        primitiveHeader = primitiveTexel(u_primitiveHeader, u_primitiveHeaderSize,
                                         cell.y * 4.0 + cell.x - primitiveHeader.w);
    }
#endif
    return true;
}

// How many triangles a point may have to be asked about; `casts`: it is on a triangle that casts
// and is seen and lit from one side. After findPrimitiveTexel() was true.
highp float primitiveCount(bool casts) {
    if (primitiveHeader.w == 0.0) return 0.0;
    highp vec4 counts =
        primitiveTexel(u_primitiveEntries, u_primitiveEntriesSize, primitiveHeader.w);
    return casts ? counts.x : counts.x + counts.w;
}

// Whether the light reaches the point. `casts`: see primitiveCount().
bool primitiveMapLights(highp vec3 point, bool casts) {
    if (!findPrimitiveTexel(point)) return true;
    if (primitiveDepth > primitiveHeader.x) return false;
    highp float count = primitiveCount(casts);
    for (int i = 1; i <= PRIMITIVE_MAP_LONGEST; ++i) {
        if (float(i) > count) break;
        highp vec4 entry = primitiveTexel(u_primitiveEntries, u_primitiveEntriesSize,
                                          primitiveHeader.w + float(i));
        if (primitiveDepth <= entry.w) break; // all further ones are deeper
        if (primitiveBlocks(entry.x, primitiveRay, point)) return false;
    }
    return true;
}
