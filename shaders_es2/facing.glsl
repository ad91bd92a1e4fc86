// Which side of a triangle is seen.
varying vec3 v_normal;    // of the vertices, of the front
uniform float u_mirrored; // 1, or -1 where the node's transform turns triangles over

// 1: the triangle's front is seen, -1: its back.
float facing() { return gl_FrontFacing ? u_mirrored : -u_mirrored; }
