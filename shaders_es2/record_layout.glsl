// Numbers that the packer (C++) and the shaders (GLSL ES 1.00) agree on. Both include this file.

// Opposite vertices that one record can hold. Two vertices of the edge, five opposite vertices and
// the corner of an instanced draw are eight attributes, the number that every device has. An edge
// with more gets further records; the sum of their multiplicities is what counts.
#define LARGEST_RECORD_MULTIPLICITY 5

// Where an opposite vertex O stands in the order of the edge A < B, in O's fourth component. Stored
// rather than compared, so that a device of low precision can't disagree with itself.
#define ORDER_ABSENT 0.0
#define ORDER_OPPOSITE_FIRST 1.0
#define ORDER_OPPOSITE_BETWEEN 2.0
#define ORDER_OPPOSITE_LAST 3.0

// Vertices that a side (two triangles) and a pair of caps (front, back) take.
#define VERTICES_PER_SIDE 6
#define VERTICES_PER_CAP_PAIR 6

// Those of one of the two draws of a triangle's volume, in the order of
// brute_force/triangle_volume.vert.
#define VERTICES_PER_TRIANGLE_VOLUME 18
#define FIRST_SIDE_VERTEX 3
#define SECOND_SIDE_VERTEX 9
#define BACK_CAP_VERTEX 15
