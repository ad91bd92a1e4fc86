// The tables of primitive_map_lookup.glsl in one texture (PackedPrimitiveMap in src/scene): the
// number pairs of the header and of the entries, two pairs a texel, then the records, each starting
// at a whole texel.
uniform highp sampler2D u_primitiveTable; // lowp, the default, may round the values
uniform highp vec3 u_primitiveTableSize;  // (columns, 1 / columns, 1 / rows)
uniform highp vec2 u_primitiveBegins;     // the texels at which entries and records begin

// Texels are numbered row by row. `columns` is a power of 2, so none of this is rounded. With GLSL
// ES 3.00, derivatives to choose a mipmap level by are undefined in a loop.
highp vec4 primitiveTexel(highp float index) {
    highp float row = floor(index * u_primitiveTableSize.y);
    highp vec2 at = vec2((index - row * u_primitiveTableSize.x + 0.5) * u_primitiveTableSize.y,
                         (row + 0.5) * u_primitiveTableSize.z);
#if __VERSION__ >= 300
    return textureLod(u_primitiveTable, at, 0.0);
#else
    return texture2D(u_primitiveTable, at);
#endif
}

// A pair of numbers, in x and w.
highp vec4 primitivePair(highp float begin, highp float index) {
    highp float pair = floor(0.5 * index);
    highp vec4 two = primitiveTexel(begin + pair);
    return index - 2.0 * pair < 0.5 ? two.xxxy : two.zzzw;
}
highp vec4 primitiveHeaderAt(highp float index) { return primitivePair(0.0, index); }
highp vec4 primitiveEntry(highp float index) { return primitivePair(u_primitiveBegins.x, index); }

highp vec4 primitiveRecord(highp float index) { return primitiveTexel(u_primitiveBegins.y + index); }
