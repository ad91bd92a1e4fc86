// Numbers that the packer (C++) and the shaders (GLSL ES 1.00) share. Both include this file.

// Opposite vertices that one record can hold. Two vertices of the edge, five opposite vertices and
// the corner of an instanced draw are eight attributes, the number that every device has. An edge
// with more gets further records; their multiplicities are added up.
#define LARGEST_RECORD_MULTIPLICITY 5

// Position of an opposite vertex O in the order of the edge A < B, in O's fourth component. Stored
// rather than compared, so that a device of low precision can't disagree with itself.
#define ORDER_ABSENT 0.0
#define ORDER_OPPOSITE_FIRST 1.0
#define ORDER_OPPOSITE_BETWEEN 2.0
#define ORDER_OPPOSITE_LAST 3.0

// Vertices of a side (two triangles) and of a pair of caps (front, back).
#define VERTICES_PER_SIDE 6
#define VERTICES_PER_CAP_PAIR 6

// Vertices of one of the two draws of a triangle's volume, in the order of
// brute_force/triangle_volume.vert.
#define VERTICES_PER_TRIANGLE_VOLUME 18
#define FIRST_SIDE_VERTEX 3
#define SECOND_SIDE_VERTEX 9
#define BACK_CAP_VERTEX 15
