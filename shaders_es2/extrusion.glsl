// Extruded positions, in one evaluation order for every program: sides and caps must meet bit for
// bit.

// toInf of the method (thesis, Equation 6.1): p pushed away from the light to infinity.
vec4 toInfinity(vec3 p, vec4 light) {
    return vec4(p.x * light.w - light.x, p.y * light.w - light.y, p.z * light.w - light.z, 0.0);
}

// Pushes p away from the light to the plane `end`. The light and, nearer to the plane, p must be
// inside it, where dot(end, (x, 1)) > 0. The plane at infinity is (0, 0, 0, 1), which gives
// toInfinity().
vec4 pushedTo(vec4 end, vec3 p, vec4 light) {
    float height = end.x * p.x + end.y * p.y + end.z * p.z + end.w;
    float ofLight = end.x * light.x + end.y * light.y + end.z * light.z + end.w * light.w;
    return vec4(p.x * ofLight - light.x * height, p.y * ofLight - light.y * height,
                p.z * ofLight - light.z * height, ofLight - height * light.w);
}

// matrix * p, with the sum spelled out.
vec4 clipPosition(mat4 matrix, vec4 p) {
    return matrix[0] * p.x + matrix[1] * p.y + matrix[2] * p.z + matrix[3] * p.w;
}

// Moves a front cap's vertex along its line of sight to the far plane (docs/method.md, C10). There
// it fails the depth test wherever its surface is visible or hidden, and never fights with that
// surface for depth.
vec4 movedToInfinity(vec4 clip) {
    return vec4(clip.xy, clip.w, clip.w);
}

// 1 / 65536. Least w of a vertex, as a share of its distance across the picture.
const float leastDepthShare = 0.0000152587890625;

// The w of a vertex, kept off the plane through the eye. Close to that plane (say when the light,
// the vertex and the eye's picture plane are in one plane) a vertex projects so far away that
// fixed-point rasterisers overflow and lose the triangle.
float keptOffEye(vec4 clip) {
    float least = leastDepthShare * max(abs(clip.x), abs(clip.y));
    return abs(clip.w) < least ? (clip.w < 0.0 ? -least : least) : clip.w;
}

// gl_Position for such a vertex. A vertex at infinity (z = w) stays there. `matrix` is the one that
// made `clip`: an orthographic one has no plane through the eye, and w is left as it is.
vec4 rasterizable(mat4 matrix, vec4 clip) {
    if (matrix[0].w == 0.0 && matrix[1].w == 0.0 && matrix[2].w == 0.0) return clip;
    float w = keptOffEye(clip);
    return w == clip.w ? clip : vec4(clip.xy, w + (clip.z - clip.w), w);
}
