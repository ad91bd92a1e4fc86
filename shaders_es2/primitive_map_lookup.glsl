// Whether a light reaches a point, by its primitive map (docs/method.md, C34; PrimitiveMap in
// src/shadow/primitive_map). For any fragment shader: bind its textures, give the point in map
// space, and define
//   PRIMITIVE_MAP_DIRECTIONAL  for a directional light, or PRIMITIVE_MAP_TILES for a point light of
//                              six tiles; neither: one of one tile
//   PRIMITIVE_MAP_ANY_LIGHT    neither of these: a uniform says which
//   PRIMITIVE_MAP_LONGEST      entries of the longest list, or more
//   PRIMITIVE_MAP_CUTOUTS      where some triangles are alpha-tested; their textures are in a fourth
//                              one then, or in the one table
//   PRIMITIVE_MAP_TINTS        where some triangles are tinted: after primitiveMapLights() returned true,
//                              primitiveTint is the share of light that these let through
//   PRIMITIVE_MAP_ONE_TABLE    where the map is one texture (primitive_map_table.glsl) instead of
//                              three (primitive_map_tables.glsl)
#undef PRIMITIVE_DIRECTIONAL
#undef PRIMITIVE_TILES
#ifdef PRIMITIVE_MAP_ANY_LIGHT
uniform highp float u_primitiveKind; // 0: a directional light; 1: a point light of one tile; 2: a
                                     // point light of six tiles
#define PRIMITIVE_DIRECTIONAL (u_primitiveKind < 0.5)
#define PRIMITIVE_TILES (u_primitiveKind > 1.5)
#else
#ifdef PRIMITIVE_MAP_DIRECTIONAL
#define PRIMITIVE_DIRECTIONAL true
#else
#define PRIMITIVE_DIRECTIONAL false
#endif
#ifdef PRIMITIVE_MAP_TILES
#define PRIMITIVE_TILES true
#else
#define PRIMITIVE_TILES false
#endif
#endif
uniform highp float u_primitiveSize; // texels along a tile's edge

#ifdef PRIMITIVE_MAP_ONE_TABLE
#include "primitive_map_table.glsl"
#else
#include "primitive_map_tables.glsl"
#endif

// Where the ray meets the last triangle's plane: a depth for a directional light, else the inverse
// of its distance, as a share of the point's.
highp float primitiveBehind;

highp float primitiveHeight;    // of the point behind that plane
highp float primitiveTolerance; // rounding error of such heights for points on the plane
highp float primitiveMoved;     // how far the point was moved towards the light
highp float primitiveReach;     // of the point's coordinates from a point light, 0..1

#ifdef PRIMITIVE_MAP_TINTS
highp vec3 primitiveTint;  // light that tinted triangles before the point let through, 0..1
highp vec3 primitiveSides; // of the ray beside the last triangle's edges
#endif

// Whether the ray meets the triangle; `ray` is (x, y, 1) for a directional light, else the point.
bool primitiveMeets(highp float record, highp vec3 ray, highp vec3 point) {
    highp vec4 a = primitiveRecord(3.0 * record);
    highp vec4 b = primitiveRecord(3.0 * record + 1.0);
    highp vec4 c = primitiveRecord(3.0 * record + 2.0);
    primitiveBehind = a.w * ray.x + b.w * ray.y + c.w * ray.z;
    primitiveHeight = PRIMITIVE_DIRECTIONAL ? point.z - primitiveBehind : primitiveBehind - 1.0;
    highp float slope = abs(a.w) + abs(b.w) + abs(c.w);
    primitiveTolerance =
        (64.0 / 16777216.0) * (1.0 + (PRIMITIVE_DIRECTIONAL ? slope : primitiveReach * slope));
    // Neighbouring triangles compute the same products, up to their sign.
    highp vec3 sides = vec3(a.x * ray.x + a.y * ray.y + a.z * ray.z,
                            b.x * ray.x + b.y * ray.y + b.z * ray.z,
                            c.x * ray.x + c.y * ray.y + c.z * ray.z);
#ifdef PRIMITIVE_MAP_TINTS
    primitiveSides = sides;
#endif
    return sides.x >= 0.0 && sides.y >= 0.0 && sides.z >= 0.0;
}

#if defined(PRIMITIVE_MAP_CUTOUTS) ||                                                              \
    (defined(PRIMITIVE_MAP_TINTS) && defined(PRIMITIVE_MAP_ONE_TABLE))
#define PRIMITIVE_TEXTURES
#endif

#ifdef PRIMITIVE_TEXTURES
#ifndef PRIMITIVE_MAP_ONE_TABLE
uniform mediump sampler2D u_primitiveAlpha; // all cutouts' textures, sampled texel by texel
uniform highp vec2 u_primitiveAlphaTexel;   // 1 / its size
#endif

// The texel of a row that a place beyond it wraps to; `wrap`: CutoutWrap.
highp float wrappedTexel(highp float place, highp float size, highp float wrap) {
    if (wrap > 1.5) return clamp(place, 0.0, size - 1.0);
    highp float period = wrap > 0.5 ? 2.0 * size : size;
    highp float rest = place - period * floor(place / period);
    return clamp(rest < size ? rest : period - 1.0 - rest, 0.0, size - 1.0);
}

// `how`: (cutoff, wrap along u, along v, linear or not).
highp float cutoutTexel(highp vec2 place, highp vec4 rectangle, highp vec4 how) {
    highp vec2 texel = vec2(wrappedTexel(place.x, rectangle.z, how.y),
                            wrappedTexel(place.y, rectangle.w, how.z));
#ifdef PRIMITIVE_MAP_ONE_TABLE
    // Eight to a texel, twelve bits each: PackedAlpha in src/shadow/primitive_map.
    highp float index = rectangle.y + texel.y * rectangle.z + texel.x;
    highp float within = floor(index * 0.125);
    highp vec4 eight = primitiveRecord(rectangle.x + within);
    within = index - 8.0 * within;
    highp vec2 pairs = within < 4.0 ? eight.xy : eight.zw;
    within = within < 4.0 ? within : within - 4.0;
    highp float two = within < 2.0 ? pairs.x : pairs.y;
    highp float second = floor(two / 4096.0);
    return (within == 1.0 || within == 3.0 ? second : two - 4096.0 * second) / 4080.0;
#else
    return texture2D(u_primitiveAlpha, (vec2(rectangle.x, rectangle.y) + texel + vec2(0.5)) * u_primitiveAlphaTexel).x;
#endif
}

highp float cutoutAlpha(highp vec2 uv, highp vec4 rectangle, highp vec4 how) {
    highp vec2 place = uv * vec2(rectangle.z, rectangle.w);
    if (how.w < 0.5) return cutoutTexel(floor(place), rectangle, how);
    place = place - vec2(0.5);
    highp vec2 first = floor(place);
    highp vec2 share = place - first;
    highp float a = cutoutTexel(first, rectangle, how);
    highp float b = cutoutTexel(first + vec2(1.0, 0.0), rectangle, how);
    highp float c = cutoutTexel(first + vec2(0.0, 1.0), rectangle, how);
    highp float d = cutoutTexel(first + vec2(1.0, 1.0), rectangle, how);
    return mix(mix(a, b, share.x), mix(c, d, share.x), share.y);
}

// The texture coordinates, by planes u and v, where a ray meets the last triangle's plane.
highp vec2 cutoutPlace(highp vec4 u, highp vec4 v, highp vec3 ray) {
    highp vec2 at = vec2(u.x * ray.x + u.y * ray.y + u.z * ray.z,
                         v.x * ray.x + v.y * ray.y + v.z * ray.z);
    return PRIMITIVE_DIRECTIONAL ? at : at / primitiveBehind;
}
#endif

#ifdef PRIMITIVE_MAP_TINTS
// Whether the triangle, which primitiveMeets() has said the ray meets, is tinted. If it is before the
// point, it takes its share of the light; a ray on an edge belongs to one of the two neighbours.
bool primitiveIsTinted(highp float record, highp vec3 ray) {
    highp vec4 taken = primitiveRecord(3.0 * record + 3.0);
    highp vec4 tint = primitiveRecord(3.0 * taken.w);
    if (tint.w >= 0.0) return false;
    bool met = (primitiveSides.x > 0.0 || taken.x > 0.5) &&
               (primitiveSides.y > 0.0 || taken.y > 0.5) &&
               (primitiveSides.z > 0.0 || taken.z > 0.5);
    if (!met || primitiveHeight <= primitiveTolerance) return true;
    primitiveTint = primitiveTint * tint.xyz;
#ifdef PRIMITIVE_TEXTURES
    highp vec4 rectangle = primitiveRecord(3.0 * taken.w + 1.0);
    if (rectangle.z > 0.0) {
        highp vec4 how = primitiveRecord(3.0 * taken.w + 2.0);
        highp vec2 at = cutoutPlace(primitiveRecord(3.0 * record + 4.0),
                                    primitiveRecord(3.0 * record + 5.0), ray);
        // Red, green and blue follow one another.
        highp vec4 layer = vec4(0.0, rectangle.z * rectangle.w, 0.0, 0.0);
        primitiveTint = primitiveTint * vec3(cutoutAlpha(at, rectangle, how),
                                             cutoutAlpha(at, rectangle + layer, how),
                                             cutoutAlpha(at, rectangle + 2.0 * layer, how));
    }
#endif
    return true;
}
#endif

#ifdef PRIMITIVE_MAP_CUTOUTS
// Whether the ray meets the solid part of the alpha-tested triangle, which primitiveMeets() has
// said it meets.
bool primitiveIsSolid(highp float record, highp vec3 ray) {
    highp vec4 u = primitiveRecord(3.0 * record + 3.0);
    highp vec4 v = primitiveRecord(3.0 * record + 4.0);
    highp vec4 a = primitiveRecord(3.0 * record + 5.0);
    highp vec4 rectangle = primitiveRecord(3.0 * u.w);
    highp vec4 how = primitiveRecord(3.0 * u.w + 1.0);
    highp float alpha = a.x * ray.x + a.y * ray.y + a.z * ray.z;
    if (!PRIMITIVE_DIRECTIONAL) alpha = alpha / primitiveBehind; // where the ray meets the plane
    if (rectangle.z > 0.0) alpha = alpha * cutoutAlpha(cutoutPlace(u, v, ray), rectangle, how);
    return alpha >= how.x;
}
#endif

// Results of findPrimitiveTexel(): the point's ray, its depth, and the texel's header.
highp vec3 primitiveRay;
highp float primitiveDepth;
highp vec4 primitiveHeader;

// Finds the texel that holds the point; false if the point is past all casters.
bool findPrimitiveTexel(highp vec3 point) {
    highp float tile = 0.0;
    highp vec2 at = vec2(point.x, point.y);
    primitiveDepth = point.z;
    if (PRIMITIVE_DIRECTIONAL) {
        primitiveRay = vec3(point.x, point.y, 1.0);
    } else {
        primitiveRay = point;
        if (PRIMITIVE_TILES) {
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
        }
        if (primitiveDepth <= 0.0) return false;
        at = at / primitiveDepth;
    }
    if (max(abs(at.x), abs(at.y)) > 1.0) return false;
    highp float halfSize = 0.5 * u_primitiveSize;
    at = at * halfSize + vec2(halfSize);
    highp vec2 cell = clamp(floor(at), vec2(0.0), vec2(u_primitiveSize - 1.0));
    highp float texel = (tile * u_primitiveSize + cell.y) * u_primitiveSize + cell.x;
    // Far more turns than there are subdivisions, so that compilers don't unroll the loop.
    for (int level = 0; level < 64; ++level) {
        primitiveHeader = primitiveHeaderAt(texel);
        if (primitiveHeader.w >= 0.0) break;
        at = (at - cell) * vec2(4.0);
        cell = clamp(floor(at), vec2(0.0), vec2(3.0));
        texel = cell.y * 4.0 + cell.x - primitiveHeader.w;
    }
    return true;
}

// Whether the texel lists no triangle to test for a point. `casts`: the point is on a triangle that
// casts, and that is seen and lit from the same side. Call it only after findPrimitiveTexel()
// returned true.
bool primitiveListIsEmpty(bool casts) {
    highp float list = primitiveHeader.w;
    return list == 0.0 || (casts && list > floor(list));
}

#ifdef PRIMITIVE_MAP_TINT
// Number of triangles that the texel lists for such points.
float primitiveListLength(bool casts) {
    if (primitiveListIsEmpty(casts)) return 0.0;
    for (int i = 0; i < PRIMITIVE_MAP_LONGEST; ++i) {
        highp vec4 entry = primitiveEntry(floor(primitiveHeader.w) + float(i));
        if (entry.w >= 1e30 || (casts && entry.x > floor(entry.x))) return float(i + 1);
    }
    return float(PRIMITIVE_MAP_LONGEST);
}
#endif

// Whether the light reaches the point. `casts`: see primitiveListIsEmpty(). Among the planes that
// the point lies on, as far as rounding shows, the nearest is its own; others may be before it
// (docs/method.md, C35).
bool primitiveMapLights(highp vec3 point, bool casts) {
#ifdef PRIMITIVE_MAP_TINTS
    primitiveTint = vec3(1.0);
#endif
    if (!findPrimitiveTexel(point)) return true;
    if (primitiveDepth > primitiveHeader.x) return false;
    if (primitiveListIsEmpty(casts)) return true;
    highp float list = floor(primitiveHeader.w);
    highp float own = 0.0, distance = 1e30, foremost = -1e30;
    highp float apart = 0.0;
    for (int i = 0; i < PRIMITIVE_MAP_LONGEST; ++i) {
        highp vec4 entry = primitiveEntry(list + float(i));
        highp float record = floor(entry.x);
#if defined(PRIMITIVE_MAP_CUTOUTS) || defined(PRIMITIVE_MAP_TINTS)
        bool hasAlpha = entry.x < 0.0; // or a tint
        if (hasAlpha) record = -1.0 - record;
#endif
        bool meets = primitiveMeets(record, primitiveRay, point);
#ifdef PRIMITIVE_MAP_TINTS
        if (meets && hasAlpha) meets = !primitiveIsTinted(record, primitiveRay);
#endif
#ifdef PRIMITIVE_MAP_CUTOUTS
        if (meets && hasAlpha) meets = primitiveIsSolid(record, primitiveRay);
#endif
        if (meets) {
            if (primitiveHeight > primitiveTolerance) return false;
            highp float height = primitiveHeight + primitiveMoved;
            if (abs(height) <= primitiveTolerance + primitiveMoved) {
                foremost = max(foremost, height);
                highp float told = 0.125 * primitiveTolerance;
                apart = max(apart, told);
                if (abs(height) < distance) {
                    distance = abs(height);
                    own = height;
                }
            }
        }
        // Tested at the end of the loop: where pixels are shaded in step, a fragment that leaves
        // early only waits for the others (docs/method.md, C34).
        if (primitiveDepth <= entry.w) break; // all further ones are deeper
        if (casts && entry.x > floor(entry.x)) break; // or only points that don't cast test them
    }
    return !casts || foremost <= own + apart;
}
