// Tells which side of a triangle is visible.
varying vec3 v_normal;    // the vertices' normal, of the front side
uniform float u_mirrored; // 1, or -1 where the node's transform mirrors triangles

// 1: the triangle's front is visible, -1: its back.
float facing() { return gl_FrontFacing ? u_mirrored : -u_mirrored; }
