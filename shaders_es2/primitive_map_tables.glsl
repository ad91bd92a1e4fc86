// The tables of primitive_map_lookup.glsl in three textures.
uniform highp sampler2D u_primitiveHeader; // lowp, the default, may round the values
uniform highp sampler2D u_primitiveEntries;
uniform highp sampler2D u_primitiveRecords;
uniform highp vec3 u_primitiveHeaderSize; // (columns, 1 / columns, 1 / rows), as in the next two
uniform highp vec3 u_primitiveEntriesSize;
uniform highp vec3 u_primitiveRecordsSize;

// Texels are numbered row by row. `columns` is a power of 2, so none of this is rounded.
highp vec4 primitiveTexel(highp sampler2D table, highp vec3 size, highp float index) {
    highp float row = floor(index * size.y);
    highp float column = index - row * size.x;
    return texture2D(table, vec2((column + 0.5) * size.y, (row + 0.5) * size.z));
}

// Pairs of numbers, in x and w.
highp vec4 primitiveHeaderAt(highp float index) {
    return primitiveTexel(u_primitiveHeader, u_primitiveHeaderSize, index);
}
highp vec4 primitiveEntry(highp float index) {
    return primitiveTexel(u_primitiveEntries, u_primitiveEntriesSize, index);
}

highp vec4 primitiveRecord(highp float index) {
    return primitiveTexel(u_primitiveRecords, u_primitiveRecordsSize, index);
}
